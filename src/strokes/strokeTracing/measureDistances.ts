/** Pixels between two yields. */
const PIXELS_PER_SLICE = 1 << 15;

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
    if (pixels < PIXELS_PER_SLICE) continue;
    pixels = 0;
    yield (0.5 * x) / width;
  }
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) room.line[x] = distances[y * width + x];
    transformLine(room, width);
    for (let x = 0; x < width; x++) distances[y * width + x] = Math.sqrt(room.squares[x]);
    pixels += width;
    if (pixels < PIXELS_PER_SLICE) continue;
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
