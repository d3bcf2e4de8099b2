import type { Matrix4, Mesh, Object3D } from 'three';
import { Vector3 } from 'three';
import { compact } from '../files/mesh/cleanMesh.js';
import type { PictureRange, PlainMesh } from '../files/mesh/PlainMesh.js';
import { placements, rangesOf } from './meshes.js';

/**
 * Chooses the parts of a model that are hidden, by their indices in rising order.
 *
 * @param names of all parts
 * @throws ModelError if a part is asked for that the model lacks
 */
export type ChooseHidden = (names: readonly string[]) => readonly number[];

/** The parts of a model, any of which can be hidden. Framing and ground stay those of the whole model. */
export interface ModelParts {
  readonly names: readonly string[];
  /** The indices of hidden parts, in rising order. Another array whenever they change. */
  readonly hidden: readonly number[];
  /** Hides these parts, and shows the others; undefined where that needs another model, as for parts that are joined to one mesh. */
  readonly hide?: (hidden: readonly number[]) => void;
  /** Corners of triangles of a part in the world, as xyz; of large parts an even sample of about `most`. */
  readonly trianglesOf: (part: number, most: number) => Float32Array;
}

/** The parts of a mesh that was joined from a file. @param root the object that holds the mesh */
export function partsOfMesh(
  { parts, positions, indices }: PlainMesh,
  hidden: readonly number[],
  root: Object3D,
): ModelParts | undefined {
  if (!parts) return undefined;
  const { names, ofVertices } = parts;
  const trianglesOf = (part: number, most: number): Float32Array => {
    const corners: number[] = [];
    for (let corner = 0; corner < indices!.length; corner += 3)
      if (ofVertices[indices![corner]] === part) corners.push(corner);
    const step = Math.ceil(corners.length / most);
    const points: number[] = [];
    for (let i = 0; i < corners.length; i += step)
      for (let k = 0; k < 3; k++) addPoint(positions, indices![corners[i] + k], root.matrixWorld, points);
    return Float32Array.from(points);
  };
  return { names, hidden, trianglesOf };
}

const point = new Vector3();

function addPoint(positions: Float32Array, vertex: number, toWorld: Matrix4, points: number[]): void {
  points.push(
    ...point
      .fromArray(positions, 3 * vertex)
      .applyMatrix4(toWorld)
      .toArray(),
  );
}

/** A mesh without some of its parts; it may be empty. */
export function withoutParts(mesh: PlainMesh, hidden: readonly number[]): PlainMesh {
  const { parts, indices } = mesh;
  if (!parts || !indices || hidden.length === 0) return mesh;
  const isHidden = new Uint8Array(parts.names.length);
  for (const part of hidden) isHidden[part] = 1;
  const kept = new Uint32Array(indices.length);
  const ranges: PictureRange[] = [];
  let length = 0;
  for (const range of mesh.ranges ?? [{ start: 0, count: indices.length, picture: -1 }]) {
    const first = length;
    for (let corner = range.start; corner < range.start + range.count; corner += 3) {
      if (isHidden[parts.ofVertices[indices[corner]]]) continue;
      for (let k = corner; k < corner + 3; k++) kept[length++] = indices[k];
    }
    if (length > first) ranges.push({ ...range, start: first, count: length - first });
  }
  return { ...compact(mesh, kept.subarray(0, length)), ...(mesh.ranges && { ranges }) };
}

/** The parts of a scene: its meshes. Hidden ones are on no layer, so that their children stay, and no camera or light sees them. */
export class SceneParts implements ModelParts {
  hidden: readonly number[] = [];

  /** @param names of the meshes, in the same order */
  constructor(
    readonly names: readonly string[],
    private readonly meshes: readonly Mesh[],
  ) {}

  readonly hide = (hidden: readonly number[]): void => {
    const isHidden = new Set(hidden);
    for (const [i, mesh] of this.meshes.entries()) mesh.layers.mask = isHidden.has(i) ? 0 : 1;
    this.hidden = hidden;
  };

  readonly trianglesOf = (part: number, most: number): Float32Array => {
    const mesh = this.meshes[part];
    const { index } = mesh.geometry;
    const ranges = rangesOf(mesh, ({ visible }) => visible);
    const matrices = placements(mesh);
    const total = (ranges.reduce((sum, { count }) => sum + count, 0) / 3) * matrices.length;
    const step = 3 * Math.ceil(total / most);
    const points: number[] = [];
    for (const matrix of matrices) {
      for (const { start, count } of ranges) {
        for (let corner = start; corner + 2 < start + count; corner += step) {
          for (let k = corner; k < corner + 3; k++) {
            mesh.getVertexPosition(index ? index.getX(k) : k, point).applyMatrix4(matrix);
            points.push(point.x, point.y, point.z);
          }
        }
      }
    }
    return Float32Array.from(points);
  };
}
