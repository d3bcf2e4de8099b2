import { testGroup } from './besideGlsl.js';

testGroup('engraving', ['several lights']);
