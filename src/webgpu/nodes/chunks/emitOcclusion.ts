/** Counterpart of shaders/chunks/emitOcclusion.glsl. */
import type { NodeBuilder } from 'three/webgpu';
import { tsl } from '../base/values.js';
import { hatchNormal } from './hatchNormal.js';
import { vOcclusion } from './occlusion.js';

const { max } = tsl;

/** Instances stand in different places, so occlusion is not baked for them. */
export function emitOcclusion(builder: NodeBuilder): void {
  const isPlaced = ['isInstancedMesh', 'isBatchedMesh'].some((kind) => kind in (builder.object as object));
  vOcclusion.assign(isPlaced ? 0 : max(hatchNormal(builder).w.negate(), 0));
}
