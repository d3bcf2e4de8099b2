import { alongPath, type LinePath, pathLength, piecesOf, type Span } from '../paths/LinePath.js';

/** The least cosine between two lines that lie along each other, some 10°. */
const LEAST_COSINE = 0.985;
/** Pieces shorter than this many times the reach are neither cut out nor left over. */
const SHORTEST = 5;
/** Cells have one index, with this distance between rows. */
const ROW = 2 ** 22;
/** Longer lines are not compared with others: most samples of one. */
const MOST_SAMPLES = 2 ** 18;

/** The outlines that were drawn so far, so that none is drawn twice where edges of several parts lie in one place. */
export class DrawnOutlines {
  /** Samples of the lines by cells: x, y and the direction of each. */
  private readonly cells = new Map<number, number[]>();

  /** @param reach the greatest distance between lines that count as one, pixels */
  constructor(private readonly reach: number) {}

  /** The pieces of a line that lie along none drawn before. They count as drawn from now on. */
  add(path: LinePath): LinePath[] {
    if (!(pathLength(path) <= MOST_SAMPLES * this.reach)) return [path];
    const spans = this.newSpans(path);
    const pieces = spans ? piecesOf(path, spans) : [path];
    for (const piece of pieces) alongPath(piece, this.reach, (x, y, dx, dy) => this.keep(x, y, dx, dy));
    return pieces;
  }

  /** The spans of a line that lie along none drawn before; null if that is all of it. */
  private newSpans(path: LinePath): Span[] | null {
    const { reach } = this;
    const shortest = SHORTEST * reach;
    const length = pathLength(path);
    /** The drawn spans, as long as they count. */
    const drawn: [from: number, to: number][] = [];
    alongPath(path, reach, (x, y, dx, dy, place) => {
      if (!this.isDrawn(x, y, dx, dy)) return;
      const last = drawn.at(-1);
      if (last && place - last[1] < 2 * reach) last[1] = place;
      else drawn.push([place, place]);
    });
    const cut = drawn.filter(([from, to]) => to - from >= Math.min(shortest, 0.5 * length));
    if (cut.length === 0) return null;
    const starts = [0, ...cut.map(([, to]) => to)];
    const ends = [...cut.map(([from]) => from), length];
    return starts.map((from, i): Span => [from, ends[i]]).filter(([from, to]) => to - from >= shortest);
  }

  private cellOf(x: number, y: number): number {
    return Math.floor(x / this.reach) + ROW * Math.floor(y / this.reach);
  }

  private keep(...sample: [x: number, y: number, dx: number, dy: number]): void {
    const cell = this.cellOf(sample[0], sample[1]);
    const known = this.cells.get(cell);
    if (known) known.push(...sample);
    else this.cells.set(cell, sample);
  }

  private isDrawn(x: number, y: number, dx: number, dy: number): boolean {
    const { reach } = this;
    for (const up of [-reach, 0, reach]) {
      for (const right of [-reach, 0, reach]) {
        const samples = this.cells.get(this.cellOf(x + right, y + up)) ?? [];
        for (let o = 0; o < samples.length; o += 4) {
          const [awayX, awayY] = [x - samples[o], y - samples[o + 1]];
          const across = Math.abs(awayX * samples[o + 3] - awayY * samples[o + 2]);
          if (across > reach || awayX * awayX + awayY * awayY > 2 * reach * reach) continue;
          if (Math.abs(dx * samples[o + 2] + dy * samples[o + 3]) >= LEAST_COSINE) return true;
        }
      }
    }
    return false;
  }
}
