import { testGroup } from './besideGlsl.js';

testGroup('faces', ['the tone of faces']);
