import { testGroup } from './besideGlsl.js';

testGroup('placed');
