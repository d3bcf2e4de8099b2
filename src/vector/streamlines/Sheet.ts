import type { DrawnScene } from '../DrawnScene.js';
import type { Projection } from '../Projection.js';
import { rasterise, type SampleGrid } from './rasterise.js';

/** Distance between samples in widths of the pen, and the greatest number of samples, which bounds the memory of large sheets. */
const SAMPLE = 1 / 3;
const MOST_SAMPLES = 2 ** 24;
/** Depth jumps at an outline: by more than this many times the slope beside it, and as many samples. */
const JUMP = 2.5;
/** Edges between a sample and the next one on its right, and the one below. */
const RIGHT = 1;
const BELOW = 2;
/** Chamfer distances to neighbours, and that of a sample beside an edge. */
const BESIDE = 3;
const ASLANT = 4;
const AT_EDGE = 1;
const FARTHEST = 255;
/** The share of a chamfer distance that is certainly free. */
const CERTAIN = 0.92;
/** Rows per step. */
const ROWS = 16;

/** What is seen on the sheet: the triangle at each sample, and the outlines between samples. Lengths in millimetres from the upper left corner of the picture. */
export class Sheet {
  readonly columns: number;
  readonly rows: number;
  /** Distance between samples, and millimetres per pixel. */
  readonly size: number;

  private constructor(
    readonly projection: Projection,
    grid: SampleGrid,
    readonly scale: number,
    /** The triangle of the scene at each sample; −1 where no line is drawn. */
    readonly triangles: Int32Array,
    /** Per triangle of the scene 1 if its front faces the camera, −1 if its back does. */
    readonly facing: Int8Array,
    /** Bits of the outlines beside each sample. */
    private readonly edges: Uint8Array,
    /** Chamfer distance of each sample from an outline. */
    private readonly away: Uint8Array,
  ) {
    this.columns = grid.columns;
    this.rows = grid.rows;
    this.size = scale / grid.perPixel;
  }

  /**
   * Looks at a scene. Yields its progress.
   *
   * @param owners per triangle of the scene the number of the surface that has lines there; −1 for none
   * @param scale millimetres per pixel
   * @param pen its width, millimetres
   */
  static *of(
    scene: Pick<DrawnScene, 'corners' | 'sides' | 'cutouts'>,
    owners: Int32Array,
    projection: Projection,
    { scale, pen }: { scale: number; pen: number },
  ): Generator<number, Sheet, void> {
    const [width, height] = [projection.width * scale, projection.height * scale];
    const size = Math.max(SAMPLE * pen, Math.sqrt((width * height) / MOST_SAMPLES));
    const grid = { columns: Math.ceil(width / size) + 1, rows: Math.ceil(height / size) + 1, perPixel: scale / size };
    const { triangles, depths, facing } = yield* rasterise(scene, projection, grid);
    const edges = new Uint8Array(triangles.length);
    const finder = new EdgeFinder(triangles, depths, owners, grid, projection);
    for (let y = 0; y < grid.rows; y++) {
      if (y % ROWS === 0) yield 1;
      for (let x = 0; x < grid.columns; x++) edges[y * grid.columns + x] = finder.bitsAt(x, y);
    }
    for (let i = 0; i < triangles.length; i++) if (triangles[i] >= 0 && owners[triangles[i]] < 0) triangles[i] = -1;
    const away = yield* distances(triangles, edges, grid);
    return new Sheet(projection, grid, scale, triangles, facing, edges, away);
  }

  get width(): number {
    return (this.columns - 1) * this.size;
  }

  get height(): number {
    return (this.rows - 1) * this.size;
  }

  /** The index of the nearest sample; −1 beside the picture. */
  private sampleAt(x: number, y: number): number {
    const [column, row] = [Math.round(x / this.size), Math.round(y / this.size)];
    return column < 0 || row < 0 || column >= this.columns || row >= this.rows ? -1 : row * this.columns + column;
  }

  /** The triangle of the scene at a place; −1 where no line is drawn. */
  triangleAt(x: number, y: number): number {
    const i = this.sampleAt(x, y);
    return i < 0 ? -1 : this.triangles[i];
  }

  /** The distance of a place from the nearest outline, at most some 8 mm; 0 where no line is drawn. */
  awayAt(x: number, y: number): number {
    const i = this.sampleAt(x, y);
    return i < 0 ? 0 : (this.away[i] * this.size) / BESIDE;
  }

  /** The direction on the sheet away from the nearest outline, unit. */
  wayFromOutline(x: number, y: number): readonly [number, number] {
    const { columns, rows, size, away } = this;
    const column = Math.min(Math.max(Math.round(x / size), 2), columns - 3);
    const row = Math.min(Math.max(Math.round(y / size), 2), rows - 3);
    const i = row * columns + column;
    const dx = away[i + 2] - away[i - 2];
    const dy = away[i + 2 * columns] - away[i - 2 * columns];
    const length = Math.hypot(dx, dy) || 1;
    return [dx / length, dy / length];
  }

  /** Whether an outline lies between two places, or no surface with lines at the second or on the way. */
  isParted(x0: number, y0: number, x1: number, y1: number): boolean {
    const { columns, rows, size, triangles, edges } = this;
    const [dx, dy] = [x1 - x0, y1 - y0];
    const free = CERTAIN * this.awayAt(x0, y0) - size;
    if (free > 0 && dx * dx + dy * dy < free * free) return false;
    const count = Math.ceil((1.5 * Math.max(Math.abs(dx), Math.abs(dy))) / size) || 1;
    let [column, row] = [Math.round(x0 / size), Math.round(y0 / size)];
    for (let k = 1; k <= count; k++) {
      const toColumn = Math.round((x0 + (k / count) * dx) / size);
      const toRow = Math.round((y0 + (k / count) * dy) / size);
      if (toColumn < 0 || toRow < 0 || toColumn >= columns || toRow >= rows) return true;
      if (triangles[toRow * columns + toColumn] < 0) return true;
      if (toColumn !== column && edges[row * columns + Math.min(column, toColumn)] & RIGHT) return true;
      if (toRow !== row && edges[Math.min(row, toRow) * columns + toColumn] & BELOW) return true;
      column = toColumn;
      row = toRow;
    }
    return false;
  }

  /** Whether an outline lies between a sample and the next ones, so many to the right or down. */
  hasEdgeBeside(column: number, row: number, count: number, isDown: boolean): boolean {
    const [step, bit] = isDown ? [this.columns, BELOW] : [1, RIGHT];
    const start = row * this.columns + column;
    for (let k = 0; k < count; k++) if (this.edges[start + k * step] & bit) return true;
    return false;
  }
}

/** Finds outlines between samples: where the surface changes, or depth jumps. */
class EdgeFinder {
  constructor(
    private readonly triangles: Int32Array,
    private readonly depths: Float32Array,
    private readonly owners: Int32Array,
    private readonly grid: SampleGrid,
    private readonly projection: Projection,
  ) {}

  bitsAt(column: number, row: number): number {
    const { columns, rows } = this.grid;
    const i = row * columns + column;
    let bits = 0;
    if (column + 1 < columns && this.isEdge(i, 1, column > 0, column + 2 < columns)) bits |= RIGHT;
    if (row + 1 < rows && this.isEdge(i, columns, row > 0, row + 2 < rows)) bits |= BELOW;
    return bits;
  }

  private isEdge(i: number, step: number, hasBefore: boolean, hasAfter: boolean): boolean {
    const { triangles, depths, owners, grid, projection } = this;
    const j = i + step;
    const [one, other] = [triangles[i], triangles[j]];
    if (one < 0 || other < 0) return one !== other;
    if (one === other) return false;
    if (owners[one] !== owners[other]) return true;
    const before = hasBefore && triangles[i - step] >= 0 ? Math.abs(depths[i] - depths[i - step]) : 0;
    const after = hasAfter && triangles[j + step] >= 0 ? Math.abs(depths[j + step] - depths[j]) : 0;
    const sample = projection.unitsPerPixel(Math.min(depths[i], depths[j])) / grid.perPixel;
    return Math.abs(depths[j] - depths[i]) > JUMP * (Math.max(before, after) + sample);
  }
}

/** Chamfer distances of samples from outlines. Yields now and then. */
function* distances(
  triangles: Int32Array,
  edges: Uint8Array,
  { columns, rows }: SampleGrid,
): Generator<number, Uint8Array, void> {
  const away = new Uint8Array(triangles.length).fill(FARTHEST);
  for (let row = 0; row < rows; row++) {
    if (row % ROWS === 0) yield 1;
    for (let column = 0; column < columns; column++) {
      const i = row * columns + column;
      if (triangles[i] < 0) away[i] = 0;
      if (edges[i] & RIGHT) away[i] = Math.min(away[i], AT_EDGE);
      if (edges[i] & RIGHT && away[i + 1] > AT_EDGE) away[i + 1] = AT_EDGE;
      if (edges[i] & BELOW) away[i] = Math.min(away[i], AT_EDGE);
      if (edges[i] & BELOW && away[i + columns] > AT_EDGE) away[i + columns] = AT_EDGE;
    }
  }
  // Forwards, then backwards.
  for (const way of [1, -1]) {
    const across = way * columns;
    for (let k = 0; k < rows; k++) {
      if (k % ROWS === 0) yield 1;
      const row = way > 0 ? k : rows - 1 - k;
      const hasRow = k > 0;
      for (let n = 0; n < columns; n++) {
        const i = row * columns + (way > 0 ? n : columns - 1 - n);
        let least = away[i];
        if (n > 0) least = Math.min(least, away[i - way] + BESIDE);
        if (hasRow) {
          least = Math.min(least, away[i - across] + BESIDE);
          if (n > 0) least = Math.min(least, away[i - across - way] + ASLANT);
          if (n < columns - 1) least = Math.min(least, away[i - across + way] + ASLANT);
        }
        away[i] = least;
      }
    }
  }
  return away;
}
