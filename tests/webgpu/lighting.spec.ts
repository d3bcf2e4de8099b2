import { testGroup } from './besideGlsl.js';

testGroup('lighting');
