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

/** The path data of a drawing, of one layer or of all. */
export function pathsOf(svg: string, layer = ''): string[] {
  const groups = [
    ...svg.matchAll(/<g id="[^"]*" inkscape:groupmode="layer" inkscape:label="\d+ ([^"]*)"[^>]*>([\s\S]*?)<\/g>/g),
  ];
  return groups
    .filter(([, name]) => name.startsWith(layer))
    .flatMap(([, , body]) => [...body.matchAll(/<path d="([^"]*)"\/>/g)].map(([, data]) => data));
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
  const shapes = paths.map(ringsOf);
  let sum = 0;
  for (let row = 0; row < rows; row++) {
    const y = top + ((row + 0.5) / rows) * height + 1e-7;
    const spans = shapes.flatMap((rings) => spansAt(rings, y));
    spans.sort((a, b) => a[0] - b[0]);
    let end = left;
    for (const [from, to] of spans) {
      const [start, stop] = [Math.max(from, end), Math.min(to, left + width)];
      if (stop > start) sum += stop - start;
      end = Math.max(end, stop);
    }
  }
  return sum / (rows * width);
}

/** The parts of a row that a shape covers. */
function spansAt(rings: readonly number[][], y: number): [number, number][] {
  const crossings: [number, number][] = [];
  for (const points of rings) {
    for (let i = 0; i < points.length; i += 2) {
      const next = (i + 2) % points.length;
      const [y0, y1] = [points[i + 1], points[next + 1]];
      if (y0 < y === y1 < y) continue;
      crossings.push([points[i] + ((y - y0) / (y1 - y0)) * (points[next] - points[i]), y0 < y1 ? 1 : -1]);
    }
  }
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
