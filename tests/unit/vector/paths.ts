/** What a file of vectors holds, read as plainly as it is written. */

/** Points of the subpaths of path data, x and y in turn, in the units of the file. */
export function ringsOf(data: string): number[][] {
  const rings: number[][] = [];
  for (const [, subpath] of data.matchAll(/(M[^M]*)/g)) {
    const numbers = [...subpath.matchAll(/-?\d*\.?\d+/g)].map(([text]) => Number(text));
    const points = numbers.slice(0, 2);
    for (let i = 2; i < numbers.length; i += 2) points.push(points[i - 2] + numbers[i], points[i - 1] + numbers[i + 1]);
    rings.push(points);
  }
  return rings;
}

/** The path data of a drawing, of the layers whose names begin so or that a pattern fits. */
export function pathsOf(svg: string, layer: string | RegExp = ''): string[] {
  const groups = [
    ...svg.matchAll(/<g id="[^"]*" inkscape:groupmode="layer" inkscape:label="\d+ ([^"]*)"[^>]*>([\s\S]*?)<\/g>/g),
  ];
  return groups
    .filter(([, name]) => (typeof layer === 'string' ? name.startsWith(layer) : layer.test(name)))
    .flatMap(([, , body]) => [...body.matchAll(/<path d="([^"]*)"\/>/g)].map(([, data]) => data));
}

/** The rings of paths that were asked about before: most drawings are measured at several places. */
const readPaths = new WeakMap<readonly string[], readonly number[][][]>();

function shapesOf(paths: readonly string[]): readonly number[][][] {
  const shapes = readPaths.get(paths) ?? paths.map(ringsOf);
  readPaths.set(paths, shapes);
  return shapes;
}

/**
 * The share of a rectangle that paths cover which are filled by the rule `nonzero`: rows of samples, each cut exactly.
 *
 * @param box left, top, width and height, in the units of the file
 */
export function coverageOf(
  paths: readonly string[],
  box: readonly [number, number, number, number],
  rows = 400,
): number {
  const [left, top, width, height] = box;
  const places = Array.from({ length: rows }, (_, row) => top + ((row + 0.5) / rows) * height + 1e-7);
  const spans = places.map((): [number, number][] => []);
  for (const rings of shapesOf(paths)) {
    for (const [row, crossings] of crossingsOf(rings, places)) spans[row].push(...spansBetween(crossings));
  }
  let sum = 0;
  for (const covered of spans) {
    covered.sort((a, b) => a[0] - b[0]);
    let end = left;
    for (const [from, to] of covered) {
      const [start, stop] = [Math.max(from, end), Math.min(to, left + width)];
      if (stop > start) sum += stop - start;
      end = Math.max(end, stop);
    }
  }
  return sum / (rows * width);
}

/** Where the rings of a shape cross rows at even distances, by the number of the row, and which way each turns there. */
function crossingsOf(rings: readonly number[][], places: readonly number[]): Map<number, [number, number][]> {
  const crossings = new Map<number, [number, number][]>();
  const perRow = (places.length - 1) / (places[places.length - 1] - places[0]);
  for (const points of rings) {
    for (let i = 0; i < points.length; i += 2) {
      const next = (i + 2) % points.length;
      const [y0, y1] = [points[i + 1], points[next + 1]];
      // One row more on both sides, as the quotient is rounded; which of them it crosses is decided exactly.
      const first = Math.max(Math.floor((Math.min(y0, y1) - places[0]) * perRow) - 1, 0);
      const last = Math.min(Math.ceil((Math.max(y0, y1) - places[0]) * perRow) + 1, places.length - 1);
      for (let row = first; row <= last; row++) {
        const y = places[row];
        if (y0 < y === y1 < y) continue;
        const x = points[i] + ((y - y0) / (y1 - y0)) * (points[next] - points[i]);
        const found = crossings.get(row);
        if (found) found.push([x, y0 < y1 ? 1 : -1]);
        else crossings.set(row, [[x, y0 < y1 ? 1 : -1]]);
      }
    }
  }
  return crossings;
}

/** The parts of a row that a shape covers. */
function spansBetween(crossings: [number, number][]): [number, number][] {
  crossings.sort((a, b) => a[0] - b[0]);
  const spans: [number, number][] = [];
  let winding = 0;
  let begin = 0;
  for (const [x, turn] of crossings) {
    if (winding === 0) begin = x;
    winding += turn;
    if (winding === 0) spans.push([begin, x]);
  }
  return spans;
}
