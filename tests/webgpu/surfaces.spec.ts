import { testGroup } from './besideGlsl.js';

testGroup('surfaces');
