import { ShapeUtils, Vector2 } from 'three';

/** The flatness below which a polygon, or a corner between two others, is degenerate, as a share of its size. */
const FLAT = 1e-9;
/** Fans around every corner are tried for polygons with up to this many corners. */
const FEW = 32;

/**
 * Triangulates a polygon in its plane. Notches and holes stay open; every corner stays a corner of a triangle, so that neighbours share
 * edges; a polygon without area gives no triangles.
 *
 * @param points xyz of the corners: of the outline, and then of the holes
 * @param holes index of the first corner of each hole
 * @returns three corner indices per triangle, in the winding of the polygon
 */
export function triangulatePolygon(points: ArrayLike<number>, holes: readonly number[] = []): number[] {
  const count = points.length / 3;
  if (count < 3) return [];
  if (count === 3) return [0, 1, 2];
  const all = Array.from({ length: count }, (_, corner) => corner);
  const normal: Normal = [0, 0, 0];
  fanNormal(points, all, holes[0] ?? count, normal);
  const length = Math.hypot(...normal);
  // A NaN corner makes triangles that are counted and left out later.
  if (!Number.isFinite(length)) return fanAround(0, count);
  const flat = FLAT * sizeOf(points) ** 2;
  if (length <= flat) return [];
  for (let hub = 0; holes.length === 0 && hub < Math.min(count, FEW); hub++) {
    if (isFan(points, all, count)) return fanAround(hub, count);
    all.push(all.shift()!);
  }
  const plane = planePoints(points, normal, length);
  const rings = ringsOf(plane, holes);
  return withAllCorners(plane, rings.flat(), cut(plane, rings), flat);
}

type Normal = [x: number, y: number, z: number];

/**
 * Writes twice the area of a polygon times its normal.
 *
 * @param points xyz of the points
 * @param corners indices of the polygon's points
 * @param count of its corners
 */
export function fanNormal(points: ArrayLike<number>, corners: ArrayLike<number>, count: number, normal: Normal): void {
  const o = 3 * corners[0];
  const [x, y, z] = [points[o], points[o + 1], points[o + 2]];
  let [nx, ny, nz] = [0, 0, 0];
  for (let i = 1; i + 1 < count; i++) {
    const [a, b] = [3 * corners[i], 3 * corners[i + 1]];
    const [ax, ay, az] = [points[a] - x, points[a + 1] - y, points[a + 2] - z];
    const [bx, by, bz] = [points[b] - x, points[b + 1] - y, points[b + 2] - z];
    nx += ay * bz - az * by;
    ny += az * bx - ax * bz;
    nz += ax * by - ay * bx;
  }
  normal[0] = nx;
  normal[1] = ny;
  normal[2] = nz;
}

const whole: Normal = [0, 0, 0];

/**
 * Whether the fan around the first corner triangulates the polygon: all its triangles have an area and the polygon's winding. Allocates
 * nothing, since files have millions of polygons.
 *
 * @param points xyz of the points
 * @param corners indices of the polygon's points
 * @param count of its corners
 */
export function isFan(points: ArrayLike<number>, corners: ArrayLike<number>, count: number): boolean {
  fanNormal(points, corners, count, whole);
  const [nx, ny, nz] = whole;
  const least = FLAT * (nx * nx + ny * ny + nz * nz);
  const o = 3 * corners[0];
  const [x, y, z] = [points[o], points[o + 1], points[o + 2]];
  for (let i = 1; i + 1 < count; i++) {
    const [a, b] = [3 * corners[i], 3 * corners[i + 1]];
    const [ax, ay, az] = [points[a] - x, points[a + 1] - y, points[a + 2] - z];
    const [bx, by, bz] = [points[b] - x, points[b + 1] - y, points[b + 2] - z];
    const turn = nx * (ay * bz - az * by) + ny * (az * bx - ax * bz) + nz * (ax * by - ay * bx);
    if (!(turn > least)) return false;
  }
  return true;
}

function sizeOf(points: ArrayLike<number>): number {
  let size = 0;
  for (let i = 3; i < points.length; i++) size = Math.max(size, Math.abs(points[i] - points[i % 3]));
  return size;
}

/** The corners projected along their normal. */
function planePoints(points: ArrayLike<number>, [nx, ny, nz]: readonly number[], length: number): Vector2[] {
  const [x, y, z] = [nx / length, ny / length, nz / length];
  // The axis farthest from the normal.
  const [ax, ay, az] = Math.abs(x) < 0.6 ? [1, 0, 0] : [0, 1, 0];
  const [bx, by, bz] = [y * az - z * ay, z * ax - x * az, x * ay - y * ax];
  const scale = 1 / Math.hypot(bx, by, bz);
  const [ux, uy, uz] = [bx * scale, by * scale, bz * scale];
  const [vx, vy, vz] = [y * uz - z * uy, z * ux - x * uz, x * uy - y * ux];
  return Array.from({ length: points.length / 3 }, (_, i) => {
    const [px, py, pz] = [0, 1, 2].map((axis) => points[3 * i + axis] - points[axis]);
    return new Vector2(ux * px + uy * py + uz * pz, vx * px + vy * py + vz * pz);
  });
}

/** Twice the signed area of a triangle, positive in the polygon's winding. */
const areaOf = (a: Vector2, b: Vector2, c: Vector2): number => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);

function fanAround(hub: number, count: number): number[] {
  const corners: number[] = [];
  for (let k = 1; k + 1 < count; k++) corners.push(hub, (hub + k) % count, (hub + k + 1) % count);
  return corners;
}

/** Corner indices of the outline and of each hole, without a repeated last corner. */
function ringsOf(plane: readonly Vector2[], holes: readonly number[]): number[][] {
  const starts = [0, ...holes, plane.length];
  return starts
    .slice(0, -1)
    .map((start, i) => {
      const ring = Array.from({ length: starts[i + 1] - start }, (_, k) => start + k);
      while (ring.length > 1 && plane[ring[ring.length - 1]].equals(plane[start])) ring.pop();
      return ring;
    })
    .filter(({ length }, i) => i === 0 || length > 2);
}

/** The triangles of three's ear clipping, in the polygon's winding. */
function cut(plane: readonly Vector2[], rings: readonly number[][]): number[] {
  const [outline, ...holes] = rings.map((ring) => ring.map((corner) => plane[corner]));
  const numbers = rings.flat();
  return ShapeUtils.triangulateShape(outline, holes).flatMap(([a, b, c]) => {
    const triangle = [numbers[a], numbers[b], numbers[c]];
    const area = areaOf(plane[triangle[0]], plane[triangle[1]], plane[triangle[2]]);
    return area < 0 ? triangle.reverse() : triangle;
  });
}

/**
 * Drops triangles without an area, and splits others at the corners that ear clipping or those triangles have left in the middle of a side.
 */
function withAllCorners(plane: readonly Vector2[], corners: readonly number[], cut: number[], flat: number): number[] {
  let triangles: number[][] = [];
  const flatCorners: number[] = [];
  for (let at = 0; at < cut.length; at += 3) {
    const triangle = cut.slice(at, at + 3);
    const [a, b, c] = triangle.map((corner) => plane[corner]);
    if (areaOf(a, b, c) > flat) triangles.push(triangle);
    else flatCorners.push(...triangle);
  }
  const used = new Set(triangles.flat());
  for (const corner of [...corners.filter((one) => !used.has(one)), ...flatCorners]) {
    triangles = triangles.flatMap((triangle) => {
      const side = sideAt(plane, triangle, corner, flat);
      if (side === -1) return [triangle];
      const [a, b, c] = [0, 1, 2].map((k) => triangle[(side + k) % 3]);
      return [
        [a, corner, c],
        [corner, b, c],
      ];
    });
  }
  return triangles.flat();
}

/** The side of a triangle that contains a corner; -1 for none. */
function sideAt(plane: readonly Vector2[], triangle: readonly number[], corner: number, flat: number): number {
  const place = plane[corner];
  return [0, 1, 2].findIndex((k) => {
    const [a, b] = [plane[triangle[k]], plane[triangle[(k + 1) % 3]]];
    const along = (place.x - a.x) * (b.x - a.x) + (place.y - a.y) * (b.y - a.y);
    return along > flat && along < a.distanceToSquared(b) - flat && Math.abs(areaOf(a, b, place)) <= flat;
  });
}

/**
 * Retriangulates polygons that were read as fans, so that concave ones keep their notches. The number of triangles stays; surplus ones
 * become degenerate and are left out later.
 *
 * @param positions xyz of the vertices
 * @param indices of the triangles; those of the polygons are overwritten
 * @param polygons start and end of each polygon's triangles in `indices`
 */
export function cutPolygons(positions: ArrayLike<number>, indices: Uint32Array, polygons: readonly number[]): void {
  const corners: number[] = [];
  for (let i = 0; i < polygons.length; i += 2) {
    const [start, end] = [polygons[i], polygons[i + 1]];
    corners.length = 0;
    corners.push(indices[start], indices[start + 1]);
    for (let k = start + 2; k < end; k += 3) corners.push(indices[k]);
    if (isFan(positions, corners, corners.length)) continue;
    const points = corners.flatMap((vertex) => [0, 1, 2].map((axis) => positions[3 * vertex + axis] ?? NaN));
    const triangles = triangulatePolygon(points);
    for (let k = start; k < end; k++) indices[k] = corners[triangles[k - start] ?? 0];
  }
}
