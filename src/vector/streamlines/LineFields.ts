import { dot, type Vec3 } from '../../look/vectors.js';
import { uphillOnPicture } from '../shading/screenGradient.js';
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
/** Cells per step. */
const CHUNK = 64;
/** What is never read as a kind of cells. */
const NOTHING = -1;
/** Kinds of cells of each surface: one for every engraver, of which there are eight at most. */
const KINDS = 8;

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
    for (let row = 0; row < fields.rows; row++) {
      for (let from = 0; from < fields.columns; from += CHUNK) {
        yield (0.9 * row) / fields.rows;
        fields.readRow(row, from, surfaces, owners, normals);
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

  private readRow(
    row: number,
    from: number,
    surfaces: readonly EvenSurface[],
    owners: Int32Array,
    normals: Float32Array,
  ): void {
    const { columns, size, sheet, kinds, sets } = this;
    for (let column = from; column < Math.min(from + CHUNK, columns); column++) {
      const [x, y] = [column * size, row * size];
      const triangle = sheet.triangles[row * SAMPLES * sheet.columns + column * SAMPLES];
      if (triangle < 0) continue;
      const owner = owners[triangle];
      const surface = surfaces[owner];
      const place = surface.placeAt(x / sheet.scale, y / sheet.scale, triangle);
      const tones = surface.tonesAt(place, triangle);
      const kind = surface.engraverIn(tones.turned);
      const engraver = surface.engraver(kind);
      const at = engraver.at(place);
      const cell = row * columns + column;
      kinds[cell] = KINDS * owner + kind;
      for (let k = 0; k < 3; k++) normals[3 * cell + k] = place.toneNormal[k];
      const lays = layTones(engraver, at, tones);
      for (let set = 0; set < lays.length; set++) {
        const laid = lays[set];
        if (!laid) continue;
        const [ux, uy] = uphillOnPicture(laid.gradient, at.smooth);
        const numbers = sets[set];
        const o = STRIDE * cell;
        numbers[o] = laid.tone;
        numbers[o + 1] = laid.density;
        // Lines run across the way uphill; twice their angle does not tell their two ways apart.
        numbers[o + 2] = uy * uy - ux * ux;
        numbers[o + 3] = -2 * ux * uy;
      }
    }
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
