import { forEachChunk } from '../../mesh/phases.js';

/** Pixels visited between two yields. */
const PIXELS_PER_SLICE = 1 << 16;

/** Properties of a pixel by its eight neighbours, clockwise from the one above, one bit each, set for ink. */
interface Rules {
  /** Whether the first and the second half of a Zhang-Suen step remove it. */
  halves: readonly [first: Uint8Array, second: Uint8Array];
  /** Whether it can be removed from a line one pixel wide but for corners, so that every pixel of a line has two neighbours. */
  corner: Uint8Array;
}

/**
 * Thins ink to lines one pixel wide, in place (Zhang and Suen 1984, without the remaining corners). The outermost pixels must be paper.
 *
 * @returns the pixels of the lines, by index; yields estimated progress in [0, 1]
 */
export function* thin(mask: Uint8Array, width: number, widest: number): Generator<number, Int32Array, void> {
  const rules = makeRules();
  const around = [-width, 1 - width, 1, width + 1, width, width - 1, -1, -width - 1];
  let inked = yield* pixelsOf(mask);
  const going = new Int32Array(inked.length);
  let step = 0;
  let looked = 0;
  for (let changed = true; changed; step++) {
    changed = false;
    for (const rule of rules.halves) {
      let count = 0;
      for (let start = 0; start < inked.length; start += PIXELS_PER_SLICE) {
        count = chooseGoing(mask, inked, around, rule, going, count, start);
        looked += PIXELS_PER_SLICE;
        if (looked % (4 * PIXELS_PER_SLICE) === 0) yield Math.min(0.99, step / (widest + 2));
      }
      for (let i = 0; i < count; i++) mask[going[i]] = 0;
      changed ||= count > 0;
    }
    inked = inked.filter((pixel) => mask[pixel] === 1);
    yield Math.min(0.99, step / (widest + 2));
  }
  for (const pixel of inked) if (rules.corner[neighboursOf(mask, pixel, around)]) mask[pixel] = 0;
  return inked.filter((pixel) => mask[pixel] === 1);
}

function* pixelsOf(mask: Uint8Array): Generator<number, Int32Array, void> {
  const starts: number[] = [];
  let count = 0;
  for (const _ of forEachChunk(mask.length, (start, end) => {
    starts.push(count);
    count += countInk(mask, start, end);
  })) {
    yield 0;
  }
  const pixels = new Int32Array(count);
  let chunk = 0;
  for (const _ of forEachChunk(mask.length, (start, end) => listInk(mask, start, end, pixels, starts[chunk++]))) {
    yield 0;
  }
  return pixels;
}

function countInk(mask: Uint8Array, start: number, end: number): number {
  let count = 0;
  for (let i = start; i < end; i++) count += mask[i];
  return count;
}

function listInk(mask: Uint8Array, start: number, end: number, pixels: Int32Array, first: number): void {
  let next = first;
  for (let i = start; i < end; i++) if (mask[i]) pixels[next++] = i;
}

function chooseGoing(
  mask: Uint8Array,
  inked: Int32Array,
  around: readonly number[],
  rule: Uint8Array,
  going: Int32Array,
  count: number,
  start: number,
): number {
  const end = Math.min(inked.length, start + PIXELS_PER_SLICE);
  let chosen = count;
  for (let i = start; i < end; i++) {
    const pixel = inked[i];
    if (mask[pixel] && rule[neighboursOf(mask, pixel, around)]) going[chosen++] = pixel;
  }
  return chosen;
}

function neighboursOf(mask: Uint8Array, pixel: number, around: readonly number[]): number {
  let bits = 0;
  for (let i = 0; i < 8; i++) bits |= mask[pixel + around[i]] << i;
  return bits;
}

function makeRules(): Rules {
  const halves: [Uint8Array, Uint8Array] = [new Uint8Array(256), new Uint8Array(256)];
  const corner = new Uint8Array(256);
  for (let bits = 0; bits < 256; bits++) {
    const has = (i: number): boolean => ((bits >> (i & 7)) & 1) === 1;
    const places = [0, 1, 2, 3, 4, 5, 6, 7];
    const count = places.filter(has).length;
    const runs = places.filter((i) => !has(i) && has(i + 1)).length;
    const [above, right, below, left] = [has(0), has(2), has(4), has(6)];
    const isBorder = count >= 2 && count <= 6 && runs === 1;
    halves[0][bits] = Number(isBorder && !(above && right && below) && !(right && below && left));
    halves[1][bits] = Number(isBorder && !(above && right && left) && !(above && below && left));
    // Neighbours touch at corners even where the one between them is paper.
    const gaps = places.filter((i) => has(i) && !has(i + 1) && !(i % 2 === 0 && has(i + 2))).length;
    corner[bits] = Number(count >= 2 && count < 8 && gaps === 1 && !(above && right && below && left));
  }
  return { halves, corner };
}

/** Pixels between two yields. */
const PIXELS_MEASURED_AT_ONCE = 1 << 15;

/**
 * The exact distance of every pixel of ink to the nearest pixel of paper, in pixels, centre to centre; 0 on paper (Felzenszwalb and
 * Huttenlocher 2012, one dimension after the other). Yields progress in [0, 1].
 */
export function* measureDistances(
  mask: Uint8Array,
  width: number,
  height: number,
): Generator<number, Float32Array, void> {
  const distances = new Float32Array(width * height);
  const far = width * width + height * height;
  const longest = Math.max(width, height);
  const room: Room = {
    line: new Float64Array(longest),
    squares: new Float64Array(longest),
    places: new Int32Array(longest),
    bounds: new Float64Array(longest + 1),
  };
  let pixels = 0;
  for (let x = 0; x < width; x++) {
    for (let y = 0; y < height; y++) room.line[y] = mask[y * width + x] ? far : 0;
    transformLine(room, height);
    for (let y = 0; y < height; y++) distances[y * width + x] = room.squares[y];
    pixels += height;
    if (pixels < PIXELS_MEASURED_AT_ONCE) continue;
    pixels = 0;
    yield (0.5 * x) / width;
  }
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) room.line[x] = distances[y * width + x];
    transformLine(room, width);
    for (let x = 0; x < width; x++) distances[y * width + x] = Math.sqrt(room.squares[x]);
    pixels += width;
    if (pixels < PIXELS_MEASURED_AT_ONCE) continue;
    pixels = 0;
    yield 0.5 + (0.5 * y) / height;
  }
  return distances;
}

/** Scratch memory for a row or column. */
interface Room {
  /** The squared distances from the previous pass. */
  line: Float64Array;
  /** The resulting squared distances. */
  squares: Float64Array;
  /** The vertices of the parabolas of the lower envelope, and the start of the range where each is the lowest. */
  places: Int32Array;
  bounds: Float64Array;
}

/** The lower envelope of a parabola at every pixel of a row or column. */
function transformLine({ line, squares, places, bounds }: Room, count: number): void {
  let last = 0;
  places[0] = 0;
  bounds[0] = -Infinity;
  bounds[1] = Infinity;
  for (let i = 1; i < count; i++) {
    let meeting = meetingOf(line, places[last], i);
    while (meeting <= bounds[last]) meeting = meetingOf(line, places[--last], i);
    places[++last] = i;
    bounds[last] = meeting;
    bounds[last + 1] = Infinity;
  }
  last = 0;
  for (let i = 0; i < count; i++) {
    while (bounds[last + 1] < i) last++;
    squares[i] = (i - places[last]) ** 2 + line[places[last]];
  }
}

const meetingOf = (line: Float64Array, a: number, b: number): number =>
  (line[b] + b * b - line[a] - a * a) / (2 * (b - a));
