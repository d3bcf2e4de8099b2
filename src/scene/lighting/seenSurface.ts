import type { ProjectedTriangles } from './readTriangles.js';

/** The visible parts of a surface. */
export interface SeenSurface {
  /** The unit normal of each part. */
  normals: Float32Array;
  /** The share of directional light that reaches each part through its baked occlusion. */
  openness: Float32Array;
  /** The visible size of each part, in pixels of a raster. */
  pixels: Uint32Array;
}

/** The width and height of the raster, in pixels. */
const SIZE = 96;
const NOTHING = -1;
/** Pixels on an edge belong to both triangles, so that rounding leaves no gap. */
const EDGE = -1e-5;

/** The index of the nearest triangle at the middle of each pixel, or NOTHING, and its nearness to the eye. */
interface Raster {
  triangles: Int32Array;
  nearness: Float32Array;
}

/** The part of the sheet that a raster covers. */
interface Frame {
  left: number;
  bottom: number;
  /** Pixels per unit of the sheet. */
  across: number;
  upwards: number;
}

/**
 * Finds the visible triangles, and their visible sizes, with a small depth raster over the part of the sheet that they cover. Parts
 * beyond the edges of the sheet are not seen.
 */
export function seenSurface(triangles: ProjectedTriangles): SeenSurface {
  const frame = frameOf(triangles);
  const pixels = new Map<number, number>();
  for (const triangle of frame ? drawNearest(triangles, frame).triangles : []) {
    if (triangle !== NOTHING) pixels.set(triangle, (pixels.get(triangle) ?? 0) + 1);
  }
  const surface: SeenSurface = {
    normals: new Float32Array(3 * pixels.size),
    openness: new Float32Array(pixels.size),
    pixels: Uint32Array.from(pixels.values()),
  };
  let part = 0;
  for (const triangle of pixels.keys()) {
    surface.normals.set(triangles.normals.subarray(3 * triangle, 3 * triangle + 3), 3 * part);
    surface.openness[part++] = triangles.openness[triangle];
  }
  return surface;
}

/** The part of the sheet that triangles cover; undefined if there are none. */
function frameOf({ corners, count }: ProjectedTriangles): Frame | undefined {
  let [left, right, bottom, top] = [1, -1, 1, -1];
  for (let i = 0; i < 9 * count; i += 3) {
    const x = corners[i];
    const y = corners[i + 1];
    if (x < left) left = x;
    if (x > right) right = x;
    if (y < bottom) bottom = y;
    if (y > top) top = y;
  }
  [left, bottom] = [Math.max(left, -1), Math.max(bottom, -1)];
  [right, top] = [Math.min(right, 1), Math.min(top, 1)];
  if (!(left < right && bottom < top)) return undefined;
  return { left, bottom, across: SIZE / (right - left), upwards: SIZE / (top - bottom) };
}

function drawNearest(triangles: ProjectedTriangles, frame: Frame): Raster {
  const raster: Raster = {
    triangles: new Int32Array(SIZE * SIZE).fill(NOTHING),
    nearness: new Float32Array(SIZE * SIZE).fill(-Infinity),
  };
  for (let triangle = 0; triangle < triangles.count; triangle++) {
    drawTriangle(raster, triangles, triangle, frame);
    if (triangles.isSample[triangle] === 1) drawMiddle(raster, triangles, triangle, frame);
  }
  return raster;
}

function drawTriangle(
  raster: Raster,
  { corners }: ProjectedTriangles,
  triangle: number,
  { left, bottom, across, upwards }: Frame,
): void {
  const i = 9 * triangle;
  const ax = (corners[i] - left) * across;
  const ay = (corners[i + 1] - bottom) * upwards;
  const bx = (corners[i + 3] - left) * across - ax;
  const by = (corners[i + 4] - bottom) * upwards - ay;
  const cx = (corners[i + 6] - left) * across - ax;
  const cy = (corners[i + 7] - bottom) * upwards - ay;
  const area = bx * cy - by * cx;
  const first = Math.max(0, Math.ceil(ax + Math.min(0, bx, cx) - 0.5));
  const last = Math.min(SIZE - 1, Math.floor(ax + Math.max(0, bx, cx) - 0.5));
  const lowest = Math.max(0, Math.ceil(ay + Math.min(0, by, cy) - 0.5));
  const highest = Math.min(SIZE - 1, Math.floor(ay + Math.max(0, by, cy) - 0.5));
  if (!(first <= last && lowest <= highest) || area === 0) return;
  const az = corners[i + 2];
  const bz = corners[i + 5] - az;
  const cz = corners[i + 8] - az;
  for (let row = lowest; row <= highest; row++) {
    const y = row + 0.5 - ay;
    for (let column = first; column <= last; column++) {
      const x = column + 0.5 - ax;
      const shareB = (x * cy - y * cx) / area;
      const shareC = (y * bx - x * by) / area;
      if (shareB < EDGE || shareC < EDGE || shareB + shareC > 1 - EDGE) continue;
      put(raster, row * SIZE + column, triangle, az + shareB * bz + shareC * cz);
    }
  }
}

/** Draws the pixel of a triangle's centre, for a triangle that stands for omitted ones. */
function drawMiddle(
  raster: Raster,
  { corners }: ProjectedTriangles,
  triangle: number,
  { left, bottom, across, upwards }: Frame,
): void {
  const i = 9 * triangle;
  const column = Math.floor(((corners[i] + corners[i + 3] + corners[i + 6]) / 3 - left) * across);
  const row = Math.floor(((corners[i + 1] + corners[i + 4] + corners[i + 7]) / 3 - bottom) * upwards);
  if (!(column >= 0 && column < SIZE && row >= 0 && row < SIZE)) return;
  put(raster, row * SIZE + column, triangle, (corners[i + 2] + corners[i + 5] + corners[i + 8]) / 3);
}

function put({ triangles, nearness }: Raster, pixel: number, triangle: number, near: number): void {
  if (near <= nearness[pixel]) return;
  nearness[pixel] = near;
  triangles[pixel] = triangle;
}
