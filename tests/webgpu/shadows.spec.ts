import { testGroup } from './besideGlsl.js';

testGroup('shadows');
