import { testGroup } from './besideGlsl.js';

testGroup('hatching', ['three layers', 'strokes on the sheet']);
