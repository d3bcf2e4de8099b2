import { dot, type Vec3 } from '../../look/vectors.js';
import { asPhase } from '../../mesh/phases.js';
import { uphillOnPicture } from '../shading/screenGradient.js';
import { IN_EDGE } from '../ToneReader.js';
import type { EvenSurface } from './EvenSurface.js';
import { LAYS, layTones } from './layTones.js';
import type { Sheet } from './Sheet.js';

/** Samples of the sheet from one cell to the next. */
const SAMPLES = 3;
/** The cosine between the normals of two cells with a crease between them, 38°. */
const CREASE = Math.cos((38 * Math.PI) / 180);
/** Rounds in which directions and tones are smoothed. */
const ROUNDS = { directions: 7, tones: 2 };
/** Numbers of a cell: its tone, that of its whole lines, and their direction as the cosine and the sine of twice its angle. */
const STRIDE = 4;
/** Cells that go on in each other: with the next on the right, and the one below. */
const RIGHT = 1;
const BELOW = 2;
/** Cells per step, and cells along a side of a block whose shadows are read together. */
const CHUNK = 64;
const BLOCK = 4;
/** What no lamps that are dark have as their bits: a cell beside surfaces. */
const NOTHING_THERE = -2;
/** Corners of a block are alike up to this cosine between normals, difference of tones, and cosine between twice their directions. */
const ALIKE = Math.cos(0.3);
const TONES = 0.05;
const TURN = Math.cos(0.5);
/** A cell is as expected from this cosine between normals on, and up to this difference of occlusion. */
const SMOOTH = Math.cos(0.08);
const EVEN = 0.03;
/** What is never read as a kind of cells. */
const NOTHING = -1;
/** Kinds of cells of each surface: one for every engraver, of which there are eight at most. */
const KINDS = 8;

/** What cells are read from, and the normals and the occlusion that they get. */
interface Reading {
  surfaces: readonly EvenSurface[];
  owners: Int32Array;
  normals: Float32Array;
  occlusions: Float32Array;
}

/** The tones and directions of the lines of a scene on its sheet, in cells. Lengths in millimetres. */
export class LineFields {
  readonly columns: number;
  readonly rows: number;
  /** Distance between cells. */
  readonly size: number;
  /** Per set of lines its cells; none for sets that no surface has. */
  private readonly sets: Float32Array[];
  /** Per cell its surface and how lines lie there, or `NOTHING`. */
  private readonly kinds: Int32Array;
  private readonly joins: Uint8Array;
  /** What `look` has found: the tone, that of whole lines, the direction, and how much the directions around agree, from 0 to 1. */
  tone = 0;
  density = 0;
  ux = 0;
  uy = 0;
  coherence = 0;

  private constructor(
    readonly sheet: Sheet,
    surfaces: readonly EvenSurface[],
  ) {
    this.columns = Math.floor((sheet.columns - 1) / SAMPLES) + 1;
    this.rows = Math.floor((sheet.rows - 1) / SAMPLES) + 1;
    this.size = SAMPLES * sheet.size;
    const count = this.columns * this.rows;
    this.sets = LAYS.map(({ name }) => {
      return new Float32Array(surfaces.some((surface) => surface.hasLay(name)) ? STRIDE * count : 0);
    });
    this.kinds = new Int32Array(count).fill(NOTHING);
    this.joins = new Uint8Array(count);
  }

  /** Reads tones and directions. Yields its progress. */
  static *of(sheet: Sheet, surfaces: readonly EvenSurface[], owners: Int32Array): Generator<number, LineFields, void> {
    const fields = new LineFields(sheet, surfaces);
    const normals = new Float32Array(3 * fields.kinds.length);
    const occlusions = new Float32Array(fields.kinds.length);
    const reading = { surfaces, owners, normals, occlusions };
    const dark = yield* asPhase(fields.readCorners(reading), 0, 0.3);
    for (let row = 0; row < fields.rows; row += BLOCK) {
      for (let column = 0; column < fields.columns; column += BLOCK) {
        if (column % CHUNK === 0) yield 0.3 + (0.6 * row) / fields.rows;
        fields.readBlock(row, column, dark, reading);
      }
    }
    for (let row = 0; row < fields.rows; row++) {
      yield 0.9;
      fields.joinRow(row, normals);
    }
    for (const set of fields.sets) if (set.length > 0) yield* fields.smooth(set);
    return fields;
  }

  /** Whether any line of a set may be drawn. */
  hasLines(set: number): boolean {
    const numbers = this.sets[set];
    for (let o = 0; o < numbers.length; o += STRIDE) if (numbers[o] > 0) return true;
    return false;
  }

  /** The tone of whole lines of a set in a cell; 0 where there is no surface. */
  densityOf(set: number, cell: number): number {
    return this.sets[set][STRIDE * cell + 1];
  }

  /** The engraver of the lines at a place where there is a surface. */
  engraverAt(x: number, y: number): number {
    const [column, row] = [Math.round(x / this.size), Math.round(y / this.size)];
    const kind = this.kinds[Math.min(row, this.rows - 1) * this.columns + Math.min(column, this.columns - 1)];
    return kind === NOTHING ? 0 : kind % KINDS;
  }

  /** Looks at a place: between cells that go on in each other numbers are linear. */
  look(set: number, x: number, y: number): void {
    const { columns, rows, size, kinds, joins } = this;
    const numbers = this.sets[set];
    const column = Math.min(Math.max(Math.floor(x / size), 0), columns - 2);
    const row = Math.min(Math.max(Math.floor(y / size), 0), rows - 2);
    const u = x / size - column;
    const v = y / size - row;
    const nearX = u > 0.5 ? 1 : 0;
    const nearY = v > 0.5 ? 1 : 0;
    const first = row * columns + column;
    const isJoinedX = (joins[first + nearY * columns] & RIGHT) !== 0;
    const isJoinedY = (joins[first + nearX] & BELOW) !== 0;
    let tone = 0;
    let density = 0;
    let cosine = 0;
    let sine = 0;
    let sum = 0;
    for (let j = 0; j < 2; j++) {
      if (j !== nearY && !isJoinedY) continue;
      for (let i = 0; i < 2; i++) {
        if (i !== nearX && !isJoinedX) continue;
        const cell = first + j * columns + i;
        if (kinds[cell] === NOTHING) continue;
        const weight = (i ? u : 1 - u) * (j ? v : 1 - v) + 1e-6;
        tone += weight * numbers[STRIDE * cell];
        density += weight * numbers[STRIDE * cell + 1];
        cosine += weight * numbers[STRIDE * cell + 2];
        sine += weight * numbers[STRIDE * cell + 3];
        sum += weight;
      }
    }
    const scale = sum > 0 ? 1 / sum : 0;
    this.tone = scale * tone;
    this.density = scale * density;
    const length = Math.sqrt(cosine * cosine + sine * sine);
    this.coherence = scale * length;
    // Half of the angle, without its arc.
    this.ux = Math.sqrt(Math.max(0.5 + (0.5 * cosine) / (length || 1), 0));
    this.uy = Math.sign(sine || 1) * Math.sqrt(Math.max(0.5 - (0.5 * cosine) / (length || 1), 0));
  }

  /** Reads the first cell of each block. Returns the lamps that are dark there; `NOTHING_THERE` beside surfaces. */
  private *readCorners(reading: Reading): Generator<number, Int32Array, void> {
    const { columns, rows } = this;
    const across = Math.ceil(columns / BLOCK);
    const dark = new Int32Array(across * Math.ceil(rows / BLOCK));
    for (let i = 0; i < dark.length; i++) {
      if (i % (CHUNK / BLOCK) === 0) yield i / dark.length;
      dark[i] = this.readCell(BLOCK * Math.floor(i / across), BLOCK * (i % across), 'traced', reading);
    }
    return dark;
  }

  /**
   * Reads the cells of a block but the first. Where the same lamps are dark at its corners, those of the next blocks, one ray to each lamp tells whether they are in
   * all of it: no soft edge runs through the block then. Where all corners lie in soft edges, its middle tells whether the edge is as wide as the block.
   */
  private readBlock(row: number, column: number, dark: Int32Array, reading: Reading): void {
    const { columns, rows } = this;
    const across = Math.ceil(columns / BLOCK);
    const corner = (row / BLOCK) * across + column / BLOCK;
    const all = dark[corner];
    const isInside = column + BLOCK < columns && row + BLOCK < rows;
    const isOne =
      isInside && all === dark[corner + 1] && all === dark[corner + across] && all === dark[corner + across + 1];
    if (isOne && all !== NOTHING_THERE && this.fillRest(row, column, all, reading)) return;
    if (isOne && all >= 0 && this.readRest(row, column, 'hard', all, reading)) return;
    this.readRest(row, column, 'traced', null, reading);
  }

  /** Reads the cells of a block but the first, as long as the same lamps are dark. Returns whether they are. expected: those lamps; null for any. */
  private readRest(
    row: number,
    column: number,
    shadowing: 'traced' | 'hard',
    expected: number | null,
    reading: Reading,
  ): boolean {
    for (let y = row; y < Math.min(row + BLOCK, this.rows); y++) {
      for (let x = column; x < Math.min(column + BLOCK, this.columns); x++) {
        if (x === column && y === row) continue;
        const found = this.readCell(y, x, shadowing, reading);
        if (expected !== null && found !== expected) return false;
      }
    }
    return true;
  }

  /**
   * Fills the cells of a block but the first between its corners, if they are of one kind and alike. Returns false, with some of them filled, where a cell differs from
   * what lies between the corners, in its surface, normal, occlusion or shadows; in soft edges, where its middle does in its tone.
   */
  private fillRest(row: number, column: number, dark: number, reading: Reading): boolean {
    const { columns, kinds, sets, sheet, size } = this;
    const { surfaces, owners, normals, occlusions } = reading;
    const first = row * columns + column;
    const kind = kinds[first];
    const owner = Math.floor(kind / KINDS);
    const surface = surfaces[owner];
    if (!surface.isPlain || !this.areAlike(first, normals)) return false;
    if (dark === IN_EDGE && !this.isWideEdge(row, column, first, reading)) return false;
    for (let y = 0; y < BLOCK; y++) {
      for (let x = 0; x < BLOCK; x++) {
        if (x === 0 && y === 0) continue;
        const cell = first + y * columns + x;
        const triangle = sheet.triangles[(row + y) * SAMPLES * sheet.columns + (column + x) * SAMPLES];
        if (triangle < 0 || owners[triangle] !== owner) return false;
        const [atX, atY] = [((column + x) * size) / sheet.scale, ((row + y) * size) / sheet.scale];
        const place = surface.placeAt(atX, atY, triangle);
        this.between(normals, 3, first, x, y);
        const { toneNormal: n } = place;
        const cosine = n[0] * normals[3 * cell] + n[1] * normals[3 * cell + 1] + n[2] * normals[3 * cell + 2];
        if (!(cosine > SMOOTH)) return false;
        this.between(occlusions, 1, first, x, y);
        if (Math.abs(occlusions[cell] - place.occlusion) > EVEN) return false;
        if (dark !== IN_EDGE && surface.darkAt(place) !== dark) return false;
        kinds[cell] = kind;
        for (const numbers of sets) if (numbers.length > 0) this.between(numbers, STRIDE, first, x, y);
      }
    }
    return true;
  }

  /** Whether the tones in the middle of a block lie between those of its corners. first: the cell at the first corner. */
  private isWideEdge(row: number, column: number, first: number, reading: Reading): boolean {
    const { sets, kinds } = this;
    const half = BLOCK / 2;
    const middle = first + half * (this.columns + 1);
    this.readCell(row + half, column + half, 'traced', reading);
    if (kinds[middle] !== kinds[first]) return false;
    for (const numbers of sets) {
      if (numbers.length === 0) continue;
      const tone = numbers[STRIDE * middle];
      this.between(numbers, STRIDE, first, half, half);
      if (Math.abs(numbers[STRIDE * middle] - tone) > EVEN) return false;
    }
    return true;
  }

  /** Whether the corners of a block are of one kind, and their normals, tones and directions alike. */
  private areAlike(first: number, normals: Float32Array): boolean {
    const { kinds, sets, columns } = this;
    for (const corner of [first + BLOCK, first + BLOCK * columns, first + BLOCK * (columns + 1)]) {
      if (kinds[corner] !== kinds[first]) return false;
      let cosine = 0;
      for (let k = 0; k < 3; k++) cosine += normals[3 * corner + k] * normals[3 * first + k];
      if (cosine < ALIKE) return false;
      for (const numbers of sets) {
        if (numbers.length === 0) continue;
        const [a, b] = [STRIDE * first, STRIDE * corner];
        if (Math.abs(numbers[a] - numbers[b]) > TONES || Math.abs(numbers[a + 1] - numbers[b + 1]) > TONES)
          return false;
        if (numbers[a] > 0 && numbers[a + 2] * numbers[b + 2] + numbers[a + 3] * numbers[b + 3] < TURN) return false;
      }
    }
    return true;
  }

  /** Writes numbers of a cell of a block as bilinear between those of the corners. first: the cell at the first corner. */
  private between(numbers: Float32Array, stride: number, first: number, x: number, y: number): void {
    const { columns } = this;
    const [u, v] = [x / BLOCK, y / BLOCK];
    const a = stride * first;
    const b = stride * (first + BLOCK);
    const c = stride * (first + BLOCK * columns);
    const d = c + stride * BLOCK;
    const cell = stride * (first + y * columns + x);
    for (let k = 0; k < stride; k++)
      numbers[cell + k] =
        (1 - v) * ((1 - u) * numbers[a + k] + u * numbers[b + k]) + v * ((1 - u) * numbers[c + k] + u * numbers[d + k]);
  }

  /** Reads a cell. Returns the lamps that are dark there, or `NOTHING_THERE`. */
  private readCell(
    row: number,
    column: number,
    shadowing: 'traced' | 'hard',
    { surfaces, owners, normals, occlusions }: Reading,
  ): number {
    const { columns, size, sheet, kinds, sets } = this;
    const [x, y] = [column * size, row * size];
    const triangle = sheet.triangles[row * SAMPLES * sheet.columns + column * SAMPLES];
    if (triangle < 0) return NOTHING_THERE;
    const owner = owners[triangle];
    const surface = surfaces[owner];
    const place = surface.placeAt(x / sheet.scale, y / sheet.scale, triangle);
    const tones = surface.tonesAt(place, triangle, shadowing);
    const kind = surface.engraverIn(tones.turned);
    const engraver = surface.engraver(kind);
    const at = engraver.at(place);
    const cell = row * columns + column;
    kinds[cell] = KINDS * owner + kind;
    for (let k = 0; k < 3; k++) normals[3 * cell + k] = place.toneNormal[k];
    occlusions[cell] = place.occlusion;
    for (const [set, laid] of layTones(engraver, at, tones).entries()) {
      const numbers = sets[set];
      if (numbers.length === 0) continue;
      const o = STRIDE * cell;
      if (!laid) {
        numbers.fill(0, o, o + STRIDE);
        continue;
      }
      const [ux, uy] = uphillOnPicture(laid.gradient, at.smooth);
      numbers[o] = laid.tone;
      numbers[o + 1] = laid.density;
      // Lines run across the way uphill; twice their angle does not tell their two ways apart.
      numbers[o + 2] = uy * uy - ux * ux;
      numbers[o + 3] = -2 * ux * uy;
    }
    return tones.dark;
  }

  private joinRow(row: number, normals: Float32Array): void {
    const { columns, rows, sheet, joins } = this;
    for (let column = 0; column < columns; column++) {
      const cell = row * columns + column;
      const [x, y] = [SAMPLES * column, SAMPLES * row];
      if (column + 1 < columns && this.goesOn(cell, cell + 1, normals) && !sheet.hasEdgeBeside(x, y, SAMPLES, false))
        joins[cell] |= RIGHT;
      if (row + 1 < rows && this.goesOn(cell, cell + columns, normals) && !sheet.hasEdgeBeside(x, y, SAMPLES, true))
        joins[cell] |= BELOW;
    }
  }

  private goesOn(one: number, other: number, normals: Float32Array): boolean {
    if (this.kinds[one] === NOTHING || this.kinds[one] !== this.kinds[other]) return false;
    const normalOf = (cell: number): Vec3 => [normals[3 * cell], normals[3 * cell + 1], normals[3 * cell + 2]];
    return dot(normalOf(one), normalOf(other)) >= CREASE;
  }

  /** Smooths the cells of a set where they go on in each other. Yields now and then. */
  private *smooth(set: Float32Array): Generator<number, void, void> {
    const { columns, kinds, joins } = this;
    const before = new Float32Array(set.length);
    for (let round = 0; round < ROUNDS.directions; round++) {
      yield 0.9;
      before.set(set);
      const first = round < ROUNDS.tones ? 0 : 2;
      for (let cell = 0; cell < kinds.length; cell++) {
        if (kinds[cell] === NOTHING) continue;
        const right = joins[cell] & RIGHT;
        const below = joins[cell] & BELOW;
        const left = cell > 0 && joins[cell - 1] & RIGHT;
        const above = cell >= columns && joins[cell - columns] & BELOW;
        const count = 2 + (right ? 1 : 0) + (left ? 1 : 0) + (below ? 1 : 0) + (above ? 1 : 0);
        for (let k = first; k < STRIDE; k++) {
          const o = STRIDE * cell + k;
          let sum = 2 * before[o];
          if (right) sum += before[o + STRIDE];
          if (left) sum += before[o - STRIDE];
          if (below) sum += before[o + STRIDE * columns];
          if (above) sum += before[o - STRIDE * columns];
          set[o] = sum / count;
        }
      }
    }
  }
}
