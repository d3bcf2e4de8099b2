import { testGroup } from './besideGlsl.js';

testGroup('shadows', ['lines that turn in a shadow']);
