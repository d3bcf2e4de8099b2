import { testGroup } from './besideGlsl.js';

testGroup('outlines', ['creases and borders of a box']);
