/** Counterpart of shaders/perFragment/viewToAnchor.glsl: the linear map from view space to the space of anchors. */
import type { BufferGeometry } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { tsl, type Value } from '../base/values.js';
import { viewToObject } from '../chunks/objectToView.js';

const { mat3, varyingProperty } = tsl;

/** The matrix by columns, since nodes have no matrix varyings. */
export const vViewToAnchor: readonly Value[] = /* @__PURE__ */ [0, 1, 2].map((column) =>
  varyingProperty('vec3', `vViewToAnchor${column}`),
);

/** Whether vertices move with their object alone, without skinning, morph targets or instances. */
export function isRigid({ object, geometry }: NodeBuilder): boolean {
  const { morphAttributes } = geometry as BufferGeometry;
  const moves = ['isSkinnedMesh', 'isInstancedMesh', 'isBatchedMesh'].some((kind) => kind in (object as object));
  return !moves && !morphAttributes.position && !morphAttributes.normal;
}

/** The matrix in the fragment shader. */
export const readViewToAnchor = (builder: NodeBuilder): Value =>
  isRigid(builder) ? viewToObject : mat3(...vViewToAnchor).toVar();
