import { testGroup } from './besideGlsl.js';

testGroup('placed', ['instances', 'a skin, strokes as deformed']);
