import { testGroup } from './besideGlsl.js';

testGroup('faces');
