import { testGroup } from './besideGlsl.js';

testGroup('environment');
