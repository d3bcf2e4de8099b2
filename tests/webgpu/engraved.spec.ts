import { testGroup } from './besideGlsl.js';

testGroup('engraved', ['several lights']);
