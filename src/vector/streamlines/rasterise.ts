import { MAY_HAVE_HOLES, SEEN_BACK, SEEN_FRONT } from '../Bvh.js';
import type { DrawnScene } from '../DrawnScene.js';
import type { Projection } from '../Projection.js';
import { Holes } from '../paint/Holes.js';

/** A grid of samples over the picture. */
export interface SampleGrid {
  columns: number;
  rows: number;
  /** Samples per pixel of the picture. */
  perPixel: number;
}

/** What is seen at each sample. */
export interface Raster {
  /** The triangle of the scene; −1 for none. */
  triangles: Int32Array;
  /** Its distance along the camera's axis; Infinity for none. */
  depths: Float32Array;
  /** Per triangle of the scene 1 if its front faces the camera, −1 if its back does. */
  facing: Int8Array;
}

/** Triangles per step, and rows of samples. */
const CHUNK = 256;
const ROWS = 32;
/** How far a sample may lie beyond an edge, as a share of the triangle, so that no sample falls between two of them. */
const EDGE = 1e-6;
/** Weights of the corners at a sample. */
const weights = new Float64Array(3);

/** Finds the nearest visible triangle at each sample by homogeneous edge functions (Olano and Greer, 1997). Yields its progress. */
export function* rasterise(
  { corners, sides, cutouts }: Pick<DrawnScene, 'corners' | 'sides' | 'cutouts'>,
  projection: Projection,
  grid: SampleGrid,
): Generator<number, Raster, void> {
  const count = grid.columns * grid.rows;
  const raster: Raster = {
    triangles: new Int32Array(count).fill(-1),
    depths: new Float32Array(count).fill(Infinity),
    facing: new Int8Array(sides.length),
  };
  const holes = new Holes(cutouts);
  const edges = new TriangleEdges(projection, grid);
  for (let t = 0; t < sides.length; t++) {
    if (t % CHUNK === CHUNK - 1) yield t / sides.length;
    if ((sides[t] & (SEEN_FRONT | SEEN_BACK)) === 0 || !edges.set(corners, t)) continue;
    raster.facing[t] = edges.isFront ? 1 : -1;
    if ((sides[t] & (edges.isFront ? SEEN_FRONT : SEEN_BACK)) === 0) continue;
    const open = (sides[t] & MAY_HAVE_HOLES) === 0 ? null : { holes, corners };
    for (let top = edges.top; top <= edges.bottom; top += ROWS) {
      if (top > edges.top) yield t / sides.length;
      fill(raster, t, edges, grid, top, Math.min(top + ROWS - 1, edges.bottom), open);
    }
  }
  return raster;
}

function fill(
  { triangles, depths }: Raster,
  t: number,
  edges: TriangleEdges,
  { columns }: SampleGrid,
  top: number,
  bottom: number,
  open: { holes: Holes; corners: Float64Array } | null,
): void {
  for (let y = top; y <= bottom; y++) {
    for (let x = edges.left; x <= edges.right; x++) {
      const depth = edges.depthAt(x, y);
      const i = y * columns + x;
      if (!(depth < depths[i])) continue;
      if (open) {
        const [a, b, c] = weights;
        const at = (k: number): number =>
          a * open.corners[9 * t + k] + b * open.corners[9 * t + 3 + k] + c * open.corners[9 * t + 6 + k];
        if (open.holes.isOpen(t, b, c, [at(0), at(1), at(2)], false)) continue;
      }
      depths[i] = depth;
      triangles[i] = t;
    }
  }
}

/** The edges of a triangle on the grid, also of one that reaches behind the camera. */
class TriangleEdges {
  isFront = false;
  /** The samples that may lie in it, inclusive. */
  left = 0;
  right = 0;
  top = 0;
  bottom = 0;
  /** Per corner x, y and w on the grid, and its depth. */
  private readonly at = new Float64Array(12);
  /** Three numbers per edge, which give a function that is linear on the grid. */
  private readonly edges = new Float64Array(9);

  constructor(
    private readonly projection: Projection,
    private readonly grid: SampleGrid,
  ) {}

  /** Sets the triangle. Returns whether any sample may lie in it. */
  set(corners: Float64Array, t: number): boolean {
    const { at, edges, projection, grid } = this;
    const { view: v, projection: p, near } = projection.camera;
    const [width, height] = [0.5 * projection.width * grid.perPixel, 0.5 * projection.height * grid.perPixel];
    let before = 0;
    for (let k = 0; k < 3; k++) {
      const o = 9 * t + 3 * k;
      const [wx, wy, wz] = [corners[o], corners[o + 1], corners[o + 2]];
      const x = v[0] * wx + v[4] * wy + v[8] * wz + v[12];
      const y = v[1] * wx + v[5] * wy + v[9] * wz + v[13];
      const z = v[2] * wx + v[6] * wy + v[10] * wz + v[14];
      const w = p[11] * z + p[15];
      at[4 * k] = width * (w + p[0] * x + p[4] * y + p[8] * z + p[12]);
      at[4 * k + 1] = height * (w - p[1] * x - p[5] * y - p[9] * z - p[13]);
      at[4 * k + 2] = w;
      at[4 * k + 3] = -z;
      if (-z < near) before++;
    }
    if (before === 3) return false;
    for (let k = 0; k < 3; k++) {
      const [a, b] = [4 * ((k + 1) % 3), 4 * ((k + 2) % 3)];
      edges[3 * k] = at[a + 1] * at[b + 2] - at[a + 2] * at[b + 1];
      edges[3 * k + 1] = at[a + 2] * at[b] - at[a] * at[b + 2];
      edges[3 * k + 2] = at[a] * at[b + 1] - at[a + 1] * at[b];
    }
    const area = at[0] * edges[0] + at[1] * edges[1] + at[2] * edges[2];
    // Rows run down, so front faces are clockwise.
    this.isFront = area < 0;
    this.bound(before > 0);
    return area !== 0 && this.left <= this.right && this.top <= this.bottom;
  }

  private bound(isCut: boolean): void {
    const { at, grid } = this;
    const [columns, rows] = [grid.columns - 1, grid.rows - 1];
    if (isCut) {
      [this.left, this.right, this.top, this.bottom] = [0, columns, 0, rows];
      return;
    }
    const [x0, x1, x2] = [at[0] / at[2], at[4] / at[6], at[8] / at[10]];
    const [y0, y1, y2] = [at[1] / at[2], at[5] / at[6], at[9] / at[10]];
    this.left = Math.max(Math.ceil(Math.min(x0, x1, x2)), 0);
    this.right = Math.min(Math.floor(Math.max(x0, x1, x2)), columns);
    this.top = Math.max(Math.ceil(Math.min(y0, y1, y2)), 0);
    this.bottom = Math.min(Math.floor(Math.max(y0, y1, y2)), rows);
  }

  /** The depth of the triangle at a sample, with the weights of its corners; Infinity where it is not. */
  depthAt(x: number, y: number): number {
    const { at, edges: e } = this;
    const a = e[0] * x + e[1] * y + e[2];
    const b = e[3] * x + e[4] * y + e[5];
    const c = e[6] * x + e[7] * y + e[8];
    const scale = 1 / (a + b + c);
    weights[0] = a * scale;
    weights[1] = b * scale;
    weights[2] = c * scale;
    if (!(weights[0] >= -EDGE && weights[1] >= -EDGE && weights[2] >= -EDGE)) return Infinity;
    const depth = weights[0] * at[3] + weights[1] * at[7] + weights[2] * at[11];
    return depth >= this.projection.camera.near ? depth : Infinity;
  }
}
