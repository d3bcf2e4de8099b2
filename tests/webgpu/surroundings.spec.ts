import { testGroup } from './besideGlsl.js';

testGroup('surroundings');
