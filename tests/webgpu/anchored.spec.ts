import { testGroup } from './besideGlsl.js';

testGroup('anchored');
