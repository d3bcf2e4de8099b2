import { EDGE, project, projectionOf } from '../../mesh/parallelProjection.js';
import type { ViewSurface } from './viewSurface.js';

/** Pixels to a side of a map. The unit sphere fills it. */
export const MAP_SIZE = 128;
/** Stands for no triangle. */
export const NOTHING = -1;
/** Of rows of fewer pixels each is tested. */
const NARROW = 6;
/** Pixels to a unit. */
const PIXELS = MAP_SIZE / 2;

/** A direction, or a place in the unit sphere. */
export type Vector = [x: number, y: number, z: number];

/** What is seen of a surface from afar in a direction. */
export interface SeenMap {
  /** The direction to the eye. */
  towards: Vector;
  /** Right and up in the map, as unit vectors. */
  right: Vector;
  up: Vector;
  /** The nearest triangle at the middle of each pixel, or {@link NOTHING}. */
  triangles: Int32Array;
  /** Its nearness to the eye, in pixels. */
  nearness: Float32Array;
  /** x, y in pixels and nearness of each vertex. */
  projected: Float32Array;
}

export const createSeenMap = ({ positions }: ViewSurface): SeenMap => ({
  towards: [0, 0, 1],
  right: [1, 0, 0],
  up: [0, 1, 0],
  triangles: new Int32Array(MAP_SIZE * MAP_SIZE),
  nearness: new Float32Array(MAP_SIZE * MAP_SIZE),
  projected: new Float32Array(positions.length),
});

/** The unit vector to an eye, by azimuth and elevation in degrees as `eyeDirection` of src/viewer/sceneSetup takes them. */
export function directionTo(azimuth: number, elevation: number): Vector {
  const [around, above] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  return [Math.cos(above) * Math.sin(around), Math.sin(above), Math.cos(above) * Math.cos(around)];
}

/** Draws a surface as seen from a direction. Backs of single-sided triangles are left out. */
export function drawSeenMap(map: SeenMap, surface: ViewSurface, azimuth: number, elevation: number): void {
  const towards = directionTo(azimuth, elevation);
  const around = (azimuth * Math.PI) / 180;
  const right: Vector = [Math.cos(around), 0, -Math.sin(around)];
  const up: Vector = [
    -towards[1] * Math.sin(around),
    Math.hypot(towards[0], towards[2]),
    -towards[1] * Math.cos(around),
  ];
  const projection = projectionOf({ right, up, towards }, { center: [0, 0, 0], radius: 1 }, MAP_SIZE);
  Object.assign(map, { towards, right, up });
  map.triangles.fill(NOTHING);
  map.nearness.fill(-Infinity);
  project(surface.positions, map.projected, projection, 0, surface.positions.length / 3);
  drawNearest(map, surface);
}

function drawNearest(map: SeenMap, { indices, isSingleSided }: ViewSurface): void {
  for (let triangle = 0; 3 * triangle < indices.length; triangle++) {
    drawTriangle(map, indices, triangle, isSingleSided !== null && isSingleSided[triangle] === 1);
  }
}

/** Draws a triangle where nothing is nearer. */
function drawTriangle(
  { triangles, nearness, projected }: SeenMap,
  indices: Uint32Array,
  triangle: number,
  isSingleSided: boolean,
): void {
  const a = 3 * indices[3 * triangle];
  const b = 3 * indices[3 * triangle + 1];
  const c = 3 * indices[3 * triangle + 2];
  const ax = projected[a];
  const ay = projected[a + 1];
  const bx = projected[b] - ax;
  const by = projected[b + 1] - ay;
  const cx = projected[c] - ax;
  const cy = projected[c + 1] - ay;
  const area = bx * cy - by * cx;
  if (area === 0 || (area < 0 && isSingleSided)) return;
  const left = Math.max(0, Math.ceil(ax + Math.min(0, bx, cx) - 0.5));
  const right = Math.min(MAP_SIZE - 1, Math.floor(ax + Math.max(0, bx, cx) - 0.5));
  if (!(left <= right)) return;
  const bottom = Math.max(0, Math.ceil(ay + Math.min(0, by, cy) - 0.5));
  const top = Math.min(MAP_SIZE - 1, Math.floor(ay + Math.max(0, by, cy) - 0.5));
  if (!(bottom <= top)) return;
  const perArea = 1 / area;
  const rightB = cy * perArea;
  const rightC = -by * perArea;
  const upB = -cx * perArea;
  const upC = bx * perArea;
  const px = left + 0.5 - ax;
  const py = bottom + 0.5 - ay;
  let rowB = px * rightB + py * upB;
  let rowC = px * rightC + py * upC;
  const az = PIXELS * projected[a + 2];
  const bz = PIXELS * projected[b + 2] - az;
  const cz = PIXELS * projected[c + 2] - az;
  for (let row = bottom; row <= top; row++) {
    let first = 0;
    let end = right - left;
    // In few pixels the search for the ends would take longer than the test of each.
    for (let edge = end < NARROW ? 3 : 0; edge < 3; edge++) {
      const weight = edge === 0 ? rowB : edge === 1 ? rowC : 1 - rowB - rowC;
      const step = edge === 0 ? rightB : edge === 1 ? rightC : -rightB - rightC;
      if (step > 0) first = Math.max(first, Math.ceil((EDGE - weight) / step));
      else if (step < 0) end = Math.min(end, Math.floor((EDGE - weight) / step));
      else if (weight < EDGE) end = -1;
    }
    let weightB = rowB + first * rightB;
    let weightC = rowC + first * rightC;
    const start = row * MAP_SIZE + left;
    for (let pixel = start + first; pixel <= start + end; pixel++) {
      if (weightB >= EDGE && weightC >= EDGE && weightB + weightC <= 1 - EDGE) {
        const near = az + weightB * bz + weightC * cz;
        if (near > nearness[pixel]) {
          nearness[pixel] = near;
          triangles[pixel] = triangle;
        }
      }
      weightB += rightB;
      weightC += rightC;
    }
    rowB += upB;
    rowC += upC;
  }
}
