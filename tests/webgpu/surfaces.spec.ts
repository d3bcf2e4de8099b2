import { testGroup } from './besideGlsl.js';

testGroup('surfaces', ['a map of colours', 'reflected light of a lamp and a sky']);
