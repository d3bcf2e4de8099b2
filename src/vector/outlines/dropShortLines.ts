import { type LinePath, PATH_STRIDE, pathLength } from '../paths/LinePath.js';
import { PlaceGrid } from '../paths/PlaceGrid.js';

/** Limits for lines that stand alone, pixels. */
export interface ShortLineLimits {
  /** Total length below which lines that meet are dropped. */
  shortest: number;
  /** Greatest distance between the end of a line and another line that it meets. */
  near: number;
}

/** Most samples of one piece of a line. */
const MOST_STEPS = 2 ** 16;

/** Removes paths that stand alone: short open ones that meet no others, or only others that are short in total too. */
export function dropShortLines<Item extends { path: LinePath }>(
  items: readonly Item[],
  limits: ShortLineLimits,
): Item[] {
  const lengths = items.map(({ path }) => pathLength(path));
  const isShort = items.map(({ path }, i) => !path.isClosed && lengths[i] < limits.shortest);
  if (!isShort.includes(true)) return [...items];
  const groups = new Groups(lengths.map((length, i) => (isShort[i] ? length : Infinity)));
  const places = new Places(limits.near);
  for (const [i, { path }] of items.entries()) places.add(path, i);
  for (const [i, { path }] of items.entries()) {
    if (!isShort[i]) continue;
    const { points } = path;
    for (const end of [0, points.length - PATH_STRIDE])
      for (const other of places.near(points[end], points[end + 1])) groups.join(i, other);
  }
  return items.filter((_, i) => groups.lengthOf(i) >= limits.shortest);
}

/** The lines near a place, by cells. */
class Places {
  private readonly grid: PlaceGrid<readonly [x: number, y: number, line: number]>;

  constructor(private readonly distance: number) {
    this.grid = new PlaceGrid(distance);
  }

  /** Adds a line by samples on it, half of the distance apart. */
  add({ points, isClosed }: LinePath, line: number): void {
    const count = points.length / PATH_STRIDE;
    for (let i = 0; i < count; i++) {
      const [from, to] = [PATH_STRIDE * i, PATH_STRIDE * ((i + 1) % count)];
      const [dx, dy] = [points[to] - points[from], points[to + 1] - points[from + 1]];
      const isLast = i === count - 1 && !isClosed;
      const asked = Math.ceil((2 * Math.hypot(dx, dy)) / this.distance);
      const steps = isLast ? 1 : Math.min(Math.max(asked, 1), MOST_STEPS);
      for (let k = 0; k < steps; k++) {
        const [x, y] = [points[from] + (k * dx) / steps, points[from + 1] + (k * dy) / steps];
        this.grid.add(x, y, [x, y, line]);
      }
    }
  }

  *near(x: number, y: number): Generator<number, void, void> {
    for (const [px, py, line] of this.grid.around(x, y)) if (Math.hypot(px - x, py - y) <= this.distance) yield line;
  }
}

/** Groups of lines that meet, with their total lengths. */
class Groups {
  private readonly parents: number[];

  constructor(private readonly lengths: number[]) {
    this.parents = lengths.map((_, i) => i);
  }

  private rootOf(line: number): number {
    let root = line;
    while (this.parents[root] !== root) root = this.parents[root];
    this.parents[line] = root;
    return root;
  }

  join(a: number, b: number): void {
    const [into, from] = [this.rootOf(a), this.rootOf(b)];
    if (into === from) return;
    this.parents[from] = into;
    this.lengths[into] += this.lengths[from];
  }

  lengthOf(line: number): number {
    return this.lengths[this.rootOf(line)];
  }
}
