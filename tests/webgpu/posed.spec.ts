import { testGroup } from './besideGlsl.js';

testGroup('posed');
