/** Reads SVG files, independently of the code that writes them. */

/** The points of each subpath of path data, x and y in turn, in the units of the file. */
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

/** The path data of a drawing, in layers whose names begin with a text or match a pattern. */
export function pathsOf(svg: string, layer: string | RegExp = ''): string[] {
  const groups = [
    ...svg.matchAll(/<g id="[^"]*" inkscape:groupmode="layer" inkscape:label="\d+ ([^"]*)"[^>]*>([\s\S]*?)<\/g>/g),
  ];
  return groups
    .filter(([, name]) => (typeof layer === 'string' ? name.startsWith(layer) : layer.test(name)))
    .flatMap(([, , body]) => [...body.matchAll(/<path d="([^"]*)"\/>/g)].map(([, data]) => data));
}

/** Parsed rings by path list, since most drawings are measured at several places. */
const readPaths = new WeakMap<readonly string[], readonly number[][][]>();

function shapesOf(paths: readonly string[]): readonly number[][][] {
  const shapes = readPaths.get(paths) ?? paths.map(ringsOf);
  readPaths.set(paths, shapes);
  return shapes;
}

/**
 * The share of a rectangle covered by paths under the rule `nonzero`: rows of samples, each cut exactly.
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

/** The crossings of the rings of a shape with evenly spaced rows, by row, with their directions. */
function crossingsOf(rings: readonly number[][], places: readonly number[]): Map<number, [number, number][]> {
  const crossings = new Map<number, [number, number][]>();
  const perRow = (places.length - 1) / (places[places.length - 1] - places[0]);
  for (const points of rings) {
    for (let i = 0; i < points.length; i += 2) {
      const next = (i + 2) % points.length;
      const [y0, y1] = [points[i + 1], points[next + 1]];
      // One row more on both sides, since the quotient is rounded; crossings themselves are exact.
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
