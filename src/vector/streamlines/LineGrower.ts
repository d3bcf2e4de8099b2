import type { LineLaws } from './LineLaws.js';
import type { LinePoints } from './LinePoints.js';

/** Length of a step, in widths of the pen; and the greatest number of them one way. */
export const STEP = 5 / 6;
const MOST_STEPS = 4000;
/** A line ends at a share of the distance to the next that differs from line to line, so that ends are staggered. */
const ENDS_AT = [0.6, 0.78] as const;
const BEGINS_AT = 0.8;
/** The cosine of the sharpest bend within a step; and the least agreement of directions around. */
const BEND = Math.cos(0.5);
const COHERENT = 0.35;
/** Lines along an outline keep away from it by a share of their distance, but at most by so many widths of the pen. */
const BESIDE_OUTLINE = 0.45;
const FARTHEST_FROM_OUTLINE = 4;
/** A carried line fits to this share of the lightest tone and of the distance, and this cosine to the direction. */
const CARRIED_LIGHTEST = 0.8;
const CARRIED_ROOM = 0.5;
const CARRIED_ALONG = Math.cos(0.35);
/** A line that has turned so much, radians, may meet itself. */
const ROUND = 2.5;

/** Grows a line from a seed as far as it may go. Lengths in millimetres. */
export class LineGrower {
  /** The last line that was grown. */
  readonly line = new GrownLine();
  private readonly back = new GrownLine();
  private readonly step: number;
  /** Lines that are not placed yet, and the number of the one that grows. */
  private beside: { lines: LinePoints; number: number } | null = null;

  constructor(
    private readonly laws: LineLaws,
    private readonly points: LinePoints,
  ) {
    this.step = STEP * laws.pen;
  }

  /** Grows a line. lot: its own chance, from 0 to 1. Returns whether there is one. */
  grow(x: number, y: number, lot: number): boolean {
    const { laws, line, back } = this;
    const { fields } = laws;
    line.count = back.count = 0;
    const apart = laws.look(x, y);
    const { ux, uy, tone, coherence } = fields;
    if (tone < laws.lightest(lot) || coherence < COHERENT || !this.isFree(x, y, ux, uy, BEGINS_AT * apart, apart))
      return false;
    line.push(x, y, ux, uy, apart);
    this.goOn(back, -1, lot);
    line.count = 0;
    for (let i = back.count - 1; i >= 0; i--) line.push(back.x[i], back.y[i], -back.ux[i], -back.uy[i], back.apart[i]);
    back.count = 0;
    line.push(x, y, ux, uy, apart);
    this.goOn(line, 1, lot);
    return true;
  }

  /** Takes the points of a carried line from one on as long as they fit. Returns the first that may begin another line. */
  take({ x, y, lot }: { x: readonly number[]; y: readonly number[]; lot: number }, from: number): number {
    const { laws, line, back } = this;
    const { fields } = laws;
    line.count = back.count = 0;
    const lightest = CARRIED_LIGHTEST * laws.endsAt(lot);
    const last = x.length - 1;
    for (let i = from; i <= last; i++) {
      const [a, b] = [Math.max(i - 1, 0), Math.min(i + 1, last)];
      const length = Math.hypot(x[b] - x[a], y[b] - y[a]) || 1;
      const [ux, uy] = [(x[b] - x[a]) / length, (y[b] - y[a]) / length];
      const apart = laws.look(x[i], y[i]);
      const isAlong = Math.abs(ux * fields.ux + uy * fields.uy) > CARRIED_ALONG && fields.coherence >= COHERENT;
      const isOff = i > from && fields.sheet.isParted(x[i - 1], y[i - 1], x[i], y[i]);
      const room = Math.max(CARRIED_ROOM * apart, laws.nearest);
      if (isOff || !isAlong || fields.tone < lightest || !this.isFree(x[i], y[i], ux, uy, room, apart))
        return Math.max(i, from + 1);
      line.push(x[i], y[i], ux, uy, apart);
    }
    return last + 1;
  }

  /** Takes over a line, and goes on from both of its ends, keeping away from the other lines beside it. */
  extend(lines: LinePoints, number: number): void {
    const { line, back } = this;
    line.count = back.count = 0;
    for (let i = lines.starts[number]; i < lines.starts[number + 1]; i++)
      line.push(lines.x[i], lines.y[i], lines.ux[i], lines.uy[i], lines.apart[i]);
    this.beside = { lines, number };
    for (let way = 0; way < 2; way++) {
      this.goOn(line, 1, lines.lots[number]);
      line.reverse();
    }
    this.beside = null;
  }

  /** Goes on from the last point of the line, one way. */
  private goOn(into: GrownLine, way: number, lot: number): void {
    const { laws, line, step } = this;
    const { fields, set } = laws;
    const share = ENDS_AT[0] + (ENDS_AT[1] - ENDS_AT[0]) * lot;
    const lightest = laws.endsAt(lot);
    let { x, y, ux, uy } = line.at(line.count - 1);
    [ux, uy] = [way * ux, way * uy];
    let turned = 0;
    for (let k = 0; k < MOST_STEPS; k++) {
      fields.look(set, x, y);
      let sign = fields.ux * ux + fields.uy * uy < 0 ? -1 : 1;
      fields.look(set, x + 0.5 * sign * step * fields.ux, y + 0.5 * sign * step * fields.uy);
      sign = fields.ux * ux + fields.uy * uy < 0 ? -1 : 1;
      const [vx, vy] = [sign * fields.ux, sign * fields.uy];
      const cosine = vx * ux + vy * uy;
      if (fields.coherence < COHERENT || cosine < BEND) return;
      turned += Math.acos(Math.min(cosine, 1));
      const [nextX, nextY] = [x + step * vx, y + step * vy];
      if (fields.sheet.isParted(x, y, nextX, nextY)) return;
      const apart = laws.look(nextX, nextY);
      if (fields.tone < lightest) return;
      const room = Math.max(share * apart, laws.nearest);
      if (
        !this.isFree(nextX, nextY, vx, vy, room, apart) ||
        (turned > ROUND && this.meetsItself(into, nextX, nextY, room))
      )
        return;
      [x, y, ux, uy] = [nextX, nextY, vx, vy];
      into.push(x, y, ux, uy, apart);
    }
  }

  private isFree(x: number, y: number, ux: number, uy: number, room: number, apart: number): boolean {
    const { laws, points } = this;
    const { sheet } = laws.fields;
    if (sheet.triangleAt(x, y) < 0) return false;
    const away = sheet.awayAt(x, y);
    if (away < BESIDE_OUTLINE * apart) {
      const [wayX, wayY] = sheet.wayFromOutline(x, y);
      const along = 1 - Math.abs(wayX * ux + wayY * uy);
      if (away < BESIDE_OUTLINE * Math.min(apart, FARTHEST_FROM_OUTLINE * laws.pen) * along * along) return false;
    }
    const radius = Math.max(room, laws.nearest);
    const { beside } = this;
    if (beside?.lines.isTaken(x, y, radius, beside.number)) return false;
    return !points.isTaken(x, y, radius);
  }

  /** Whether a place lies beside the line itself, which has gone on to there. */
  private meetsItself(into: GrownLine, x: number, y: number, room: number): boolean {
    const far = Math.ceil((3 * room + 1.5 * this.laws.pen) / this.step);
    const isNear = (one: GrownLine, end: number): boolean => {
      for (let i = 0; i < end; i += 2) {
        const [dx, dy] = [one.x[i] - x, one.y[i] - y];
        if (dx * dx + dy * dy < room * room) return true;
      }
      return false;
    };
    if (into === this.back) return isNear(this.back, this.back.count - far);
    return isNear(this.line, this.line.count - far);
  }
}

/** The points of a line while it grows. */
class GrownLine {
  count = 0;
  x = new Float64Array(2 * MOST_STEPS + 1);
  y = new Float64Array(2 * MOST_STEPS + 1);
  ux = new Float64Array(2 * MOST_STEPS + 1);
  uy = new Float64Array(2 * MOST_STEPS + 1);
  apart = new Float64Array(2 * MOST_STEPS + 1);

  push(x: number, y: number, ux: number, uy: number, apart: number): void {
    const i = this.count++;
    this.x[i] = x;
    this.y[i] = y;
    this.ux[i] = ux;
    this.uy[i] = uy;
    this.apart[i] = apart;
  }

  reverse(): void {
    for (const numbers of [this.x, this.y, this.apart]) numbers.subarray(0, this.count).reverse();
    for (const ways of [this.ux, this.uy]) {
      ways.subarray(0, this.count).reverse();
      for (let i = 0; i < this.count; i++) ways[i] = -ways[i];
    }
  }

  at(i: number): { x: number; y: number; ux: number; uy: number } {
    return { x: this.x[i], y: this.y[i], ux: this.ux[i], uy: this.uy[i] };
  }
}
