import { testGroup } from './besideGlsl.js';

testGroup('outlines', ['sides of a box that fade, are hidden or pass every test', 'creases and borders of a box']);
