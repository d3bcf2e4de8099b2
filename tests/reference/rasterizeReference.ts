import { mat4, vec4 } from 'gl-matrix';
import type { Triangle, Vec3 } from './referenceAdjacency.js';

export interface ReferenceCamera {
  view: number[];
  projection: number[];
}

/** The visible triangle at a pixel centre. */
export interface ReferenceFragment {
  triangle: number;
  /** Perspective-correct. */
  barycentric: Vec3;
  /** 1 seen from the front, −1 from the back. */
  faceDirection: number;
}

/**
 * Rasterizes triangles at pixel centres, in double precision; row 0 is the bottom row, as readPixels gives it. All
 * triangles must lie in front of the camera.
 *
 * @param subpixelBits - the subpixel precision of the GPU, which moves vertices to the nearest position of a grid. This shows at sharp
 *   edges. By default vertices are not moved.
 * @returns one entry per pixel, null where nothing is seen.
 */
export function rasterizeReference(
  triangles: readonly Triangle[],
  matrixWorld: number[],
  camera: ReferenceCamera,
  width: number,
  height: number,
  doubleSided: boolean,
  subpixelBits?: number,
): (ReferenceFragment | null)[] {
  const world = matrixWorld as unknown as mat4;
  const viewWorld = mat4.multiply(mat4.create(), camera.view as unknown as mat4, world);
  const clip = mat4.multiply(mat4.create(), camera.projection as unknown as mat4, viewWorld);
  const mirrored = mat4.determinant(world) < 0;
  const fragments: (ReferenceFragment | null)[] = new Array(width * height).fill(null);
  const depths = new Float64Array(width * height).fill(Number.POSITIVE_INFINITY);

  const snap = (pixels: number) =>
    subpixelBits === undefined ? pixels : Math.round(pixels * 2 ** subpixelBits) / 2 ** subpixelBits;

  triangles.forEach((triangle, index) => {
    const corners = triangle.map((v) => {
      const [x, y, z, w] = vec4.transformMat4([0, 0, 0, 0], [v[0], v[1], v[2], 1], clip) as number[];
      return { x: snap(((x! / w! + 1) / 2) * width), y: snap(((y! / w! + 1) / 2) * height), z: z! / w, w: w! };
    });
    const [a, b, c] = corners as [(typeof corners)[0], (typeof corners)[0], (typeof corners)[0]];
    const area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area === 0) return;
    const faceDirection = area > 0 !== mirrored ? 1 : -1;
    if (faceDirection < 0 && !doubleSided) return;
    const left = Math.max(0, Math.floor(Math.min(a.x, b.x, c.x)));
    const right = Math.min(width - 1, Math.ceil(Math.max(a.x, b.x, c.x)));
    const bottom = Math.max(0, Math.floor(Math.min(a.y, b.y, c.y)));
    const top = Math.min(height - 1, Math.ceil(Math.max(a.y, b.y, c.y)));
    for (let row = bottom; row <= top; row++) {
      for (let column = left; column <= right; column++) {
        const x = column + 0.5;
        const y = row + 0.5;
        const wa = ((b.x - x) * (c.y - y) - (c.x - x) * (b.y - y)) / area;
        const wb = ((c.x - x) * (a.y - y) - (a.x - x) * (c.y - y)) / area;
        const wc = 1 - wa - wb;
        if (wa < 0 || wb < 0 || wc < 0) continue;
        const depth = wa * a.z + wb * b.z + wc * c.z;
        const pixel = row * width + column;
        if (depth >= depths[pixel]) continue;
        depths[pixel] = depth;
        const sum = wa / a.w + wb / b.w + wc / c.w;
        fragments[pixel] = {
          triangle: index,
          barycentric: [wa / a.w / sum, wb / b.w / sum, wc / c.w / sum],
          faceDirection,
        };
      }
    }
  });
  return fragments;
}

/** Pixels whose eight neighbours are covered too: silhouettes are left out, where rasterizers may differ. */
export function interiorPixels(
  fragments: readonly (ReferenceFragment | null)[],
  width: number,
  height: number,
): number[] {
  const interior: number[] = [];
  for (let row = 1; row < height - 1; row++) {
    for (let column = 1; column < width - 1; column++) {
      let covered = true;
      for (let dy = -1; dy <= 1 && covered; dy++) {
        for (let dx = -1; dx <= 1 && covered; dx++) {
          covered = fragments[(row + dy) * width + column + dx] !== null;
        }
      }
      if (covered) interior.push(row * width + column);
    }
  }
  return interior;
}
