import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  InstancedBufferGeometry,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Sphere,
  Vector3,
} from 'three';
import type { BakeResult } from '../adjacency/bake.js';
import { CORNER_STRIDE, cornerLayout } from '../adjacency/cornerLayout.js';
import type { CornerRange } from './cornerRange.js';
import type { HatchingStatistics } from './HatchingStatistics.js';
import { attributeFromWords, isInstanced, type KeptAttribute } from './vertexAttributes.js';

/**
 * A new geometry with all that a bake does not touch: name, user data, groups, instancing. Made before the bake starts,
 * so that what the caller does to `source` meanwhile has no influence.
 */
export function startCornerGeometry(source: BufferGeometry, range: CornerRange): BufferGeometry {
  const geometry = 'isInstancedBufferGeometry' in source ? new InstancedBufferGeometry() : new BufferGeometry();
  if (geometry instanceof InstancedBufferGeometry) {
    geometry.instanceCount = (source as InstancedBufferGeometry).instanceCount;
  }
  geometry.name = source.name;
  geometry.userData = { ...source.userData };
  geometry.morphTargetsRelative = source.morphTargetsRelative;
  for (const group of range.groups) geometry.addGroup(group.start, group.count, group.materialIndex);
  const clonedBuffers = {};
  for (const [name, attribute] of Object.entries(source.attributes)) {
    if (!isInstanced(attribute)) continue;
    geometry.setAttribute(name, 'data' in attribute ? attribute.clone(clonedBuffers) : attribute.clone());
  }
  return geometry;
}

/** Fills the geometry with the baked corners, the kept attributes, the bounds and the statistics. */
export function applyCorners(geometry: BufferGeometry, kept: readonly KeptAttribute[], result: BakeResult): void {
  geometry.setAttribute('position', new BufferAttribute(result.positions, 3));
  const buffer = new InterleavedBuffer(result.corners, CORNER_STRIDE);
  let offset = 0;
  for (const { name, itemSize } of cornerLayout) {
    geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, itemSize, offset));
    offset += itemSize;
  }
  for (const [i, { name, isMorphTarget, attribute }] of kept.entries()) {
    const expanded = attributeFromWords(attribute, result.attributes[i]!);
    if (!isMorphTarget) geometry.setAttribute(name, expanded);
    else
      (geometry.morphAttributes as Record<string, BufferAttribute[]>)[name] = [
        ...(geometry.morphAttributes[name as 'position'] ?? []),
        expanded,
      ] as BufferAttribute[];
  }
  if (result.normals) geometry.setAttribute('normal', new BufferAttribute(result.normals, 3));
  applyBounds(geometry, result);
  const { borderEdges, nonManifoldEdges, inconsistentEdges, degenerateTriangles } = result;
  const statistics: HatchingStatistics = {
    triangles: result.positions.length / 9,
    borderEdges,
    nonManifoldEdges,
    inconsistentEdges,
    degenerateTriangles,
    layout: 'corner',
    bytes: bytesOf(geometry),
  };
  geometry.userData.hatching = statistics;
}

function applyBounds(geometry: BufferGeometry, { bounds }: BakeResult): void {
  if (geometry.morphAttributes.position) {
    // The bounds of three.js include the morph targets; the bake knows the rest pose only.
    geometry.computeBoundingBox();
    geometry.computeBoundingSphere();
    return;
  }
  const box = new Box3(new Vector3(...bounds.min), new Vector3(...bounds.max));
  geometry.boundingBox = box;
  geometry.boundingSphere = new Sphere(box.getCenter(new Vector3()), bounds.radius);
}

function bytesOf(geometry: BufferGeometry): number {
  const arrays = new Set<ArrayBufferView>();
  for (const attribute of Object.values(geometry.attributes)) arrays.add(attribute.array);
  for (const targets of Object.values(geometry.morphAttributes))
    for (const { array } of targets ?? []) arrays.add(array);
  let bytes = 0;
  for (const { byteLength } of arrays) bytes += byteLength;
  return bytes;
}
