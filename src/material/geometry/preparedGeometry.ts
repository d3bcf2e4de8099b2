import { Box3, BufferAttribute, type BufferGeometry, Sphere, Vector3 } from 'three';
import type { EdgeCounts } from '../../mesh/adjacency/pairEdges.js';
import type { BakeReport } from '../../mesh/bake/bakeSurface.js';
import type { TaskOptions } from '../../worker/TaskOptions.js';
import { isFormed } from './formGeometry.js';
import { OutlineData, setOutlineData } from './OutlineData.js';
import { isUsableNormal, type Repairs } from './repairValues.js';
import { rememberPositions } from './staleGeometry.js';
import type { VertexAttribute } from './vertexAttributes.js';

/** The value of `userData.hatching` on a prepared geometry. */
export interface HatchingStatistics extends EdgeCounts, Repairs {
  /** The number of triangles, degenerate ones included. */
  triangles: number;
  /** The vertex layout. */
  layout: 'corner' | 'pull' | 'indexed';
  /** What lines with `direction: 'auto'` follow: the form if the geometry was prepared for it, otherwise the light. */
  direction: 'form' | 'light';
  /** The size of all vertex, index, morph and texture data of the prepared geometry, in bytes. */
  bytes: number;
}

/** The data of a prepared geometry that does not come from the bake. */
export interface NotBaked extends Repairs, Pick<TaskOptions, 'createWorker'> {}

/** Sets the computed normals of a geometry: all of them, or only those that cannot be used as they are. */
export function setNormals(geometry: BufferGeometry, normals: Float32Array<ArrayBuffer>): void {
  if (geometry.attributes.normal) replaceUnusableNormals(geometry.attributes.normal, normals);
  else geometry.setAttribute('normal', new BufferAttribute(normals, 3));
}

/** Sets the bounds, the outlines and `userData.hatching`, once all attributes are set. */
export function finishGeometry(
  geometry: BufferGeometry,
  layout: HatchingStatistics['layout'],
  report: BakeReport & NotBaked,
  textureBytes = 0,
): void {
  applyBounds(geometry, report);
  const outlines = report.outlines && new OutlineData(report.outlines, report.createWorker);
  const { borderEdges, nonManifoldEdges, unpairedEdges, inconsistentEdges, degenerateTriangles } = report;
  const { computedNormals, turnedTriangles, zeroedValues } = report;
  const statistics: HatchingStatistics = {
    triangles: (geometry.index ?? geometry.attributes.position).count / 3,
    borderEdges,
    nonManifoldEdges,
    unpairedEdges,
    inconsistentEdges,
    degenerateTriangles,
    computedNormals,
    zeroedValues,
    turnedTriangles,
    layout,
    direction: isFormed(geometry) ? 'form' : 'light',
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

/** Replaces the normals that cannot be used by computed ones. */
function replaceUnusableNormals(normal: VertexAttribute, computed: Float32Array): void {
  for (let vertex = 0; vertex < normal.count; vertex++) {
    if (isUsableNormal(normal, vertex)) continue;
    normal.setXYZ(vertex, computed[3 * vertex], computed[3 * vertex + 1], computed[3 * vertex + 2]);
  }
}
