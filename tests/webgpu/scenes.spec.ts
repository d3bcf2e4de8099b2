import { testGroup } from './besideGlsl.js';

testGroup('scenes');
