/** Helpers of the tests of vector files in a browser. */
import './toolkit.js';
import * as THREE from 'three';
import { drawSVG } from 'three-hatching/svg';
import { comparedScene, compareLines, compareScene, inkOfFile } from '../../tools/metrics/linesAgainstCanvas.js';
import { loadModel } from '../../tools/metrics/loadModel.js';

const vectors = { THREE, drawSVG, compareLines, compareScene, comparedScene, inkOfFile, loadModel };

declare global {
  interface Window {
    vectors: typeof vectors;
  }
}
window.vectors = vectors;
