import { testGroup } from './besideGlsl.js';

testGroup('scenes', ['the preset woodcut']);
