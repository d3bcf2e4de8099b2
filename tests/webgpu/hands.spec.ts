import { testGroup } from './besideGlsl.js';

testGroup('hands', ['a brush along the form']);
