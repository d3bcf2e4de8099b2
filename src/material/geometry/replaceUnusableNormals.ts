import { isUsableNormal } from './repairValues.js';
import type { VertexAttribute } from './vertexAttributes.js';

/** Replaces the normals that cannot be used by computed ones. */
export function replaceUnusableNormals(normal: VertexAttribute, computed: Float32Array): void {
  for (let vertex = 0; vertex < normal.count; vertex++) {
    if (isUsableNormal(normal, vertex)) continue;
    normal.setXYZ(vertex, computed[3 * vertex], computed[3 * vertex + 1], computed[3 * vertex + 2]);
  }
}
