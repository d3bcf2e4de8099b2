import { alongPath, type LinePath, pathLength, piecesOf, type Span } from '../paths/LinePath.js';
import { PlaceGrid } from '../paths/PlaceGrid.js';

/** The least cosine between two lines that lie along each other, some 10°. */
const LEAST_COSINE = 0.985;
/** Pieces shorter than this many times the reach are neither cut out nor left over. */
const SHORTEST = 5;
/** Longer lines are not compared with others: most samples of one. */
const MOST_SAMPLES = 2 ** 18;

/** A place on a line, with the direction of the line there as a unit vector. */
type Sample = readonly [x: number, y: number, dx: number, dy: number];

/** The outlines that were drawn so far, so that none is drawn twice where edges of several parts lie in one place. */
export class DrawnOutlines {
  private readonly samples: PlaceGrid<Sample>;

  /** @param reach the greatest distance between lines that count as one, pixels */
  constructor(private readonly reach: number) {
    this.samples = new PlaceGrid(reach);
  }

  /** The pieces of a line that lie along none drawn before. They count as drawn from now on. */
  add(path: LinePath): LinePath[] {
    const length = pathLength(path);
    if (!(length <= MOST_SAMPLES * this.reach)) return [path];
    const spans = this.newSpans(path, length);
    const pieces = spans ? piecesOf(path, spans) : [path];
    for (const piece of pieces) alongPath(piece, this.reach, (x, y, dx, dy) => this.samples.add(x, y, [x, y, dx, dy]));
    return pieces;
  }

  /** The spans of a line that lie along none drawn before; null if that is all of it. */
  private newSpans(path: LinePath, length: number): Span[] | null {
    const { reach } = this;
    const shortest = SHORTEST * reach;
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

  private isDrawn(x: number, y: number, dx: number, dy: number): boolean {
    const { reach } = this;
    for (const [otherX, otherY, alongX, alongY] of this.samples.around(x, y)) {
      const [awayX, awayY] = [x - otherX, y - otherY];
      const across = Math.abs(awayX * alongY - awayY * alongX);
      if (across > reach || awayX * awayX + awayY * awayY > 2 * reach * reach) continue;
      if (Math.abs(dx * alongX + dy * alongY) >= LEAST_COSINE) return true;
    }
    return false;
  }
}
