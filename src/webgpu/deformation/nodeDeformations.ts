import type { WebGPURenderer } from 'three/webgpu';
import { Deformations } from '../../material/deformation/Deformations.js';
import { NodePosePass } from './NodePosePass.js';

/** The deformed geometries of WebGPURenderer. */
export const nodeDeformations: Deformations<WebGPURenderer> = /* @__PURE__ */ new Deformations<WebGPURenderer>(
  (renderer) => renderer,
  (renderer, geometry, vertices) => new NodePosePass(renderer, geometry, vertices),
);

/** Whether the device can render into float textures. Every WebGPU device can. */
export const hasFloatTargets = ({ backend }: WebGPURenderer): boolean =>
  (backend as { extensions?: { has(name: string): boolean } }).extensions?.has('EXT_color_buffer_float') ?? true;
