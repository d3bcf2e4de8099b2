import { testGroup } from './besideGlsl.js';

testGroup('posed', ['outlines of a skin with a morph target']);
