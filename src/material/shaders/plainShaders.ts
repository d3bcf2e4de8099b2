import { ShaderLib } from 'three';
import fragmentShader from '../../../shaders/plain.frag?raw';
import type { Shaders } from './hatchingShaders.js';

/** The shaders of plain paper, drawn while the code of a technique loads. */
export const plainShaders = (): Shaders => ({ vertexShader: ShaderLib.basic.vertexShader, fragmentShader });
