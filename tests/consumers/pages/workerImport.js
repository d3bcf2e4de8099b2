import BakeWorker from 'three-hatching/bake.worker?worker';
import { renderHatchedCube } from './renderHatchedCube.js';

window.rendering = renderHatchedCube({ createWorker: () => new BakeWorker() });
