import { testGroup } from './besideGlsl.js';

testGroup('meetings', ['parts that move, in two inks, in a fog']);
