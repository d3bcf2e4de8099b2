import { mat3, mat4, vec3 } from 'gl-matrix';
import type { ReferenceCamera } from './rasterizeReference.js';
import type { Vec3 } from './referenceAdjacency.js';
import { cross, dot, mixed, turned, unit } from './vectors.js';

interface PlacedScene {
  matrixWorld: number[];
  camera: ReferenceCamera;
  /** The width and height of the picture, in pixels. */
  size: number;
}

/**
 * The Jacobian from two tangents of the surface to pixels, from the derivatives of the whole projection. It gives the length of the screen
 * gradient of any function.
 */
export class ScreenPlane {
  private readonly tangents: [Vec3, Vec3];
  private readonly pixels: [[number, number], [number, number]];
  private readonly area: number;
  private readonly viewToObject: mat3;

  constructor({ matrixWorld, camera, size }: PlacedScene, place: Vec3, normal: Vec3) {
    const objectToView = mat4.multiply(mat4.create(), camera.view as unknown as mat4, matrixWorld as unknown as mat4);
    this.viewToObject = mat3.invert(mat3.create(), mat3.fromMat4(mat3.create(), objectToView))!;
    const q = vec3.transformMat4([0, 0, 0], place, objectToView) as Vec3;
    const n = unit(turned(normal, mat3.transpose(mat3.create(), this.viewToObject)));
    // Any two tangents work.
    const start: Vec3 = Math.abs(n[2]) < 0.7 ? [0, 0, 1] : [1, 0, 0];
    const e = unit(mixed(start, 1, n, -dot(start, n)));
    this.tangents = [e, cross(n, e)];
    const p = camera.projection;
    const clip = (row: number, v: Vec3, w: number) =>
      p[row] * v[0] + p[4 + row] * v[1] + p[8 + row] * v[2] + p[12 + row] * w;
    const depth = clip(3, q, 1);
    // The quotient rule: x/w changes by (dx − x/w · dw)/w.
    const moved = (row: number, v: Vec3) =>
      ((clip(row, v, 0) - (clip(row, q, 1) / depth) * clip(3, v, 0)) / depth) * (size / 2);
    this.pixels = this.tangents.map((t) => [moved(0, t), moved(1, t)]) as [[number, number], [number, number]];
    const [[a, b], [c, d]] = this.pixels;
    const faceOn = (p[5] * size) / 2 / depth;
    // The angle is limited: the area on the screen counts as at least 0.12 of that face on.
    this.area = Math.max(Math.abs(a * d - b * c), 0.12 * faceOn ** 2);
  }

  /** Units of the function per pixel. gradient: in object space. */
  gradientLength(gradient: Vec3): number {
    return Math.hypot(...this.gradient(gradient));
  }

  /** Units of one function per pixel along the lines of another. */
  rateAlong(place: Vec3, lines: Vec3): number {
    const [[a, b], [c, d]] = [this.gradient(place), this.gradient(lines)];
    return Math.abs(a * d - b * c) / Math.hypot(c, d);
  }

  private gradient(gradient: Vec3): [number, number] {
    const inView = turned(gradient, mat3.transpose(mat3.create(), this.viewToObject));
    const [along, aside] = this.tangents.map((t) => dot(t, inView)) as [number, number];
    // Solves s · pixels(t) = gradient · t for both tangents, by Cramer's rule.
    const [[a, b], [c, d]] = this.pixels;
    return [(along * d - b * aside) / this.area, (a * aside - along * c) / this.area];
  }
}
