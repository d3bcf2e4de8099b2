import { renderHatchedCube } from './renderHatchedCube.js';

window.rendering = renderHatchedCube();
