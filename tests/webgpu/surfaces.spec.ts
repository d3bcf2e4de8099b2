import { testGroup } from './besideGlsl.js';

testGroup('surfaces', ['a map of colours', 'planned values of a map', 'reflected light of a lamp and a sky']);
