import { MathUtils, type Mesh, type Object3D, Vector3 } from 'three';
import { drawnMeshes, isSolid, rangesOf } from '../drawing/drawnParts.js';
import type { Motion } from '../drawing/Motion.js';
import { placements } from '../files/scenes/placements.js';

/** Size of the cells of a grid over the model, in radii. */
const CELL = 1 / 32;
/** Number of cells along each side of the grid. Parts of a moving model outside it count in the outermost cells. */
const CELLS = 80;
/** Edges are split into parts of at most this length, placed at their midpoints. Triangles with shorter edges are placed at their centres. */
const LONGEST = CELL / 2;
/**
 * The largest horizontal distance between a caster and the geometry that it represents: half the diagonal of a cell, and two thirds of a
 * triangle of that length.
 */
export const CASTER_ERROR = CELL * Math.SQRT1_2 + (2 / 3) * LONGEST;
/** The maximum number of sampled poses of a clip, and of corners in all of them. */
const MOST_POSES = 8;
const MOST_CORNERS = 60_000;
/** The maximum number of corners of a still model, which take some 30 ms; larger meshes are sampled evenly. */
const MOST_STILL_CORNERS = 450_000;
/** Meshes with fewer corners are never sampled. */
const FEW_CORNERS = 3_000;

/**
 * The parts of a model that cast shadows, as vertical segments: x, z, and the heights of bottom and top for each. They follow the edges of
 * triangles, since no triangle's shadow extends beyond that of its edges. Hidden and see-through parts cast none.
 *
 * @param root the model in the world, with a radius of 1 around the origin
 * @param motion of the model, all of whose poses count
 */
export function castersOf(root: Object3D, motion?: Motion): Float32Array {
  const pieces = new UprightPieces();
  root.updateWorldMatrix(true, true);
  const casting = drawnMeshes(root);
  const corners = casting.reduce((sum, mesh) => sum + cornersOf(mesh), 0);
  if (!motion) {
    const step = Math.ceil(corners / MOST_STILL_CORNERS);
    for (const mesh of casting) addEdges(mesh, cornersOf(mesh) < FEW_CORNERS ? 1 : step, pieces);
    return pieces.take();
  }
  const poses = motion.duration > 0 ? MathUtils.clamp(Math.floor(MOST_CORNERS / corners), 1, MOST_POSES) : 1;
  const step = Math.ceil((corners * poses) / MOST_CORNERS);
  const { time } = motion;
  for (let pose = 0; pose < poses; pose++) {
    if (poses > 1) motion.time = (pose / poses) * motion.duration;
    root.updateWorldMatrix(true, true);
    for (const mesh of casting) addEdges(mesh, step, pieces);
  }
  motion.time = time;
  root.updateWorldMatrix(true, true);
  return pieces.take();
}

const cornersOf = (mesh: Mesh): number => rangesOf(mesh, isSolid).reduce((sum, { count }) => sum + count, 0);

const ends = [new Vector3(), new Vector3(), new Vector3()];
const place = new Vector3();

/** Adds the edges of every `step`th triangle, in the present pose. */
function addEdges(mesh: Mesh, step: number, pieces: UprightPieces): void {
  const { index } = mesh.geometry;
  const ranges = rangesOf(mesh, isSolid);
  for (const matrix of placements(mesh)) {
    for (const { start, count } of ranges) {
      for (let first = start; first + 2 < start + count; first += 3 * step) {
        for (let i = 0; i < 3; i++) {
          const corner = first + i;
          mesh.getVertexPosition(index ? index.getX(corner) : corner, ends[i]).applyMatrix4(matrix);
        }
        addTriangle(ends[0], ends[1], ends[2], pieces);
      }
    }
  }
}

function addTriangle(a: Vector3, b: Vector3, c: Vector3, pieces: UprightPieces): void {
  if (Math.max(a.distanceToSquared(b), b.distanceToSquared(c), c.distanceToSquared(a)) < LONGEST ** 2) {
    place.addVectors(a, b).add(c).divideScalar(3);
    pieces.add(place, Math.min(a.y, b.y, c.y), Math.max(a.y, b.y, c.y));
    return;
  }
  addEdge(a, b, pieces);
  addEdge(b, c, pieces);
  addEdge(c, a, pieces);
}

function addEdge(from: Vector3, to: Vector3, pieces: UprightPieces): void {
  const parts = Math.ceil(from.distanceTo(to) / LONGEST);
  // A mesh with NaN coordinates is not drawn.
  if (!(parts < Infinity)) return;
  if (parts <= 1) pieces.add(from, from.y, to.y);
  const rise = (to.y - from.y) / parts;
  for (let i = 0; parts > 1 && i < parts; i++)
    pieces.add(place.lerpVectors(from, to, (i + 0.5) / parts), from.y + i * rise, from.y + (i + 1) * rise);
}

/** The height range that a model fills in each column of a grid. */
class UprightPieces {
  private readonly lows = new Float32Array(CELLS ** 3).fill(Infinity);
  private readonly highs = new Float32Array(CELLS ** 3).fill(-Infinity);

  /** Adds a point that represents the height range at its place. */
  add({ x, y, z }: Vector3, one: number, other: number): void {
    const { lows, highs } = this;
    const cell = (cellOf(x) * CELLS + cellOf(z)) * CELLS + cellOf(y);
    lows[cell] = Math.min(lows[cell], one, other);
    highs[cell] = Math.max(highs[cell], one, other);
  }

  /** The vertical segments, with touching ones merged. */
  take(): Float32Array {
    const { lows, highs } = this;
    const pieces: number[] = [];
    for (let cell = 0; cell < lows.length; cell++) {
      if (lows[cell] === Infinity) continue;
      const column = Math.floor(cell / CELLS);
      let [low, high] = [lows[cell], highs[cell]];
      while ((cell + 1) % CELLS > 0 && lows[cell + 1] < Infinity) {
        cell++;
        low = Math.min(low, lows[cell]);
        high = Math.max(high, highs[cell]);
      }
      pieces.push(middleOf(Math.floor(column / CELLS)), middleOf(column % CELLS), low, high);
    }
    return Float32Array.from(pieces);
  }
}

const cellOf = (place: number): number => MathUtils.clamp(Math.floor(place / CELL + CELLS / 2), 0, CELLS - 1);

const middleOf = (cell: number): number => (cell + 0.5 - CELLS / 2) * CELL;
