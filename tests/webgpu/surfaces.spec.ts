import { testGroup } from './besideGlsl.js';

testGroup('surfaces', [
  'a map of colours',
  'details of a map that are finer than lines',
  'planned values of a map',
  'reflected light of a lamp and a sky',
]);
