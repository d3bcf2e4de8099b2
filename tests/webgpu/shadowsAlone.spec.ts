import { testGroup } from './besideGlsl.js';

testGroup('shadowsAlone', ['shadows alone, of a cone']);
