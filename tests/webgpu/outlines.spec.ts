import { testGroup } from './besideGlsl.js';

testGroup('outlines');
