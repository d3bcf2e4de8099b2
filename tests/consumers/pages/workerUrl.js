import { renderHatchedCube } from './renderHatchedCube.js';

const createWorker = () => new Worker(new URL('three-hatching/bake.worker', import.meta.url), { type: 'module' });
window.rendering = renderHatchedCube({ createWorker });
