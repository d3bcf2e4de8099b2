import { Box3, BufferAttribute, BufferGeometry, InstancedBufferGeometry, Sphere, Vector3 } from 'three';
import type { BakeReport } from '../bake/bakeSurface.js';
import type { CornerRange } from './cornerRange.js';
import { isFormed } from './formGeometry.js';
import type { HatchingStatistics } from './HatchingStatistics.js';
import { OutlineData, setOutlineData } from './OutlineData.js';
import { type Repairs, replaceUnusableNormals } from './repairValues.js';
import { rememberPositions } from './staleGeometry.js';
import { isInstanced } from './vertexAttributes.js';

/**
 * Creates the new geometry with everything that the bake does not change: name, user data, groups and instanced attributes. It
 * is created before the bake starts, so that later changes of `source` have no effect.
 */
export function startGeometry(source: BufferGeometry, range: CornerRange): BufferGeometry {
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

/** Sets the computed normals of a geometry: all of them, or only those that cannot be used as they are. */
export function setNormals(geometry: BufferGeometry, normals: Float32Array<ArrayBuffer>): void {
  if (geometry.attributes.normal) replaceUnusableNormals(geometry.attributes.normal, normals);
  else geometry.setAttribute('normal', new BufferAttribute(normals, 3));
}

/** Sets the bounds, the outlines and `userData.hatching`, once all attributes are set. */
export function finishGeometry(
  geometry: BufferGeometry,
  layout: HatchingStatistics['layout'],
  report: BakeReport & Repairs,
  textureBytes = 0,
): void {
  applyBounds(geometry, report);
  const outlines = report.outlines && new OutlineData(report.outlines);
  const { borderEdges, nonManifoldEdges, inconsistentEdges, degenerateTriangles, computedNormals, zeroedValues } =
    report;
  const statistics: HatchingStatistics = {
    triangles: (geometry.index ?? geometry.attributes.position).count / 3,
    borderEdges,
    nonManifoldEdges,
    inconsistentEdges,
    degenerateTriangles,
    computedNormals,
    zeroedValues,
    layout,
    lineField: isFormed(geometry) ? 'form' : 'light',
    bytes: bytesOf(geometry) + textureBytes + (outlines?.bytes ?? 0),
  };
  geometry.userData.hatching = statistics;
  if (outlines) setOutlineData(geometry, outlines);
  rememberPositions(geometry);
}

function applyBounds(geometry: BufferGeometry, { bounds }: BakeReport): void {
  if (geometry.morphAttributes.position) {
    // three.js includes the morph targets in the bounds, whereas the bake only knows the rest pose.
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
  if (geometry.index) arrays.add(geometry.index.array);
  let bytes = 0;
  for (const { byteLength } of arrays) bytes += byteLength;
  return bytes;
}
