import type { SurfaceImage } from './SurfaceImage.js';

/** The luminance below which a pixel belongs to a stroke: the ends of strokes are thinner than a pixel, and cover little of it. */
const TOUCHED = 0.75;
/** A piece of fewer pixels is noise. */
const LEAST_AREA = 4;
/** Pixels between the points by which the length of a way is measured: its steps go in eight directions alone. */
const CHORD = 6;

/** A connected piece of ink. */
export interface CentreLine {
  /** The length of the longest way within it from end to end, less its mean width: that of the way of a round pen, in pixels. */
  length: number;
  /** Its ink, in pixels. */
  ink: number;
  /** The pixel in the middle of that way. */
  middle: number;
}

/**
 * The connected pieces of ink, joined at sides and corners, with the length of each along its centre line: the longest of the shortest ways
 * from pixel to pixel within it. It is found as the way from the pixel farthest from any to the one farthest from that, which is exact
 * in pieces without holes.
 */
export function centreLines(image: SurfaceImage): CentreLine[] {
  const { width, luminance, surface } = image;
  const isOn = (i: number): boolean => surface[i] !== 0 && luminance[i] < TOUCHED;
  const search = new WaySearch(image, isOn);
  const seen = new Uint8Array(luminance.length);
  const pieces: CentreLine[] = [];
  for (let start = 0; start < luminance.length; start++) {
    if (seen[start] || !isOn(start)) continue;
    const piece = search.from(start);
    let ink = 0;
    for (const i of piece) {
      seen[i] = 1;
      ink += 1 - luminance[i];
    }
    if (piece.length < LEAST_AREA) continue;
    const end = search.from(piece[piece.length - 1]).at(-1)!;
    const way = search.wayTo(end);
    const whole = lengthOf(way, width);
    pieces.push({ length: whole - ink / whole, ink, middle: way[way.length >> 1] });
  }
  return pieces;
}

/** The length along pixels, measured in chords, with half a pixel at each end. */
function lengthOf(way: readonly number[], width: number): number {
  const steps = Math.max(1, Math.round((way.length - 1) / CHORD));
  const at = (step: number): number => way[Math.round((step * (way.length - 1)) / steps)];
  let length = 1;
  for (let step = 1; step <= steps; step++) {
    const [from, to] = [at(step - 1), at(step)];
    length += Math.hypot((to % width) - (from % width), Math.floor(to / width) - Math.floor(from / width));
  }
  return length;
}

/** Shortest ways within the ink, by Dijkstra's algorithm with buckets of a tenth of a pixel. */
class WaySearch {
  private readonly distances: Float32Array;
  private readonly before: Int32Array;

  constructor(
    private readonly image: SurfaceImage,
    private readonly isOn: (i: number) => boolean,
  ) {
    const pixels = image.width * image.height;
    this.distances = new Float32Array(pixels);
    this.before = new Int32Array(pixels);
  }

  /** All pixels of the piece, from the nearest to the farthest. */
  from(start: number): number[] {
    const { distances, before, image, isOn } = this;
    const { width, height } = image;
    const reached: number[] = [];
    const known = new Set<number>();
    const buckets: number[][] = [[start]];
    distances[start] = 0;
    before[start] = -1;
    const found = new Set([start]);
    for (let bucket = 0; bucket < buckets.length; bucket++) {
      for (const i of buckets[bucket] ?? []) {
        if (known.has(i)) continue;
        known.add(i);
        reached.push(i);
        const [x, y] = [i % width, Math.floor(i / width)];
        for (let row = Math.max(0, y - 1); row <= Math.min(height - 1, y + 1); row++) {
          for (let column = Math.max(0, x - 1); column <= Math.min(width - 1, x + 1); column++) {
            const next = row * width + column;
            if (next === i || !isOn(next)) continue;
            const distance = distances[i] + (row === y || column === x ? 1 : Math.SQRT2);
            if (found.has(next) && distances[next] <= distance) continue;
            found.add(next);
            distances[next] = distance;
            before[next] = i;
            const later = Math.floor(10 * distance);
            buckets[later] ??= [];
            buckets[later].push(next);
          }
        }
      }
    }
    return reached;
  }

  /** The pixels of the way from the last start to a pixel. */
  wayTo(end: number): number[] {
    const way: number[] = [];
    for (let i = end; i >= 0; i = this.before[i]) way.push(i);
    return way.reverse();
  }
}
