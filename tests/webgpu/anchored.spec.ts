import { testGroup } from './besideGlsl.js';

testGroup('anchored', ['three layers', 'strokes on the sheet']);
