import { testGroup } from './besideGlsl.js';

testGroup('shadowsAlone');
