import type { Vec3 } from '../look/vectors.js';
import type { FadedPlace } from './shading/fading.js';

/** A matrix of 16 numbers, column-major. */
export type Matrix = ArrayLike<number>;

/** A point, transformed by a matrix. */
export const transformed = (m: Matrix, x: number, y: number, z: number): Vec3 => [
  m[0] * x + m[4] * y + m[8] * z + m[12],
  m[1] * x + m[5] * y + m[9] * z + m[13],
  m[2] * x + m[6] * y + m[10] * z + m[14],
];

/** The matrices of a camera. */
export interface CameraMatrices {
  /** From world to view, and back. */
  view: Matrix;
  world: Matrix;
  projection: Matrix;
  /** Distance of the near plane, world units. */
  near: number;
}

/** The projection of a camera, from the world to pixels of the picture, which count from its upper left corner. */
export class Projection {
  readonly isOrthographic: boolean;
  /** Position of the camera, and the direction towards it along its axis; world space. */
  readonly eye: Vec3;
  readonly backwards: Vec3;

  /** @param width and `height` of the picture, pixels */
  constructor(
    readonly camera: CameraMatrices,
    readonly width: number,
    readonly height: number,
  ) {
    const { world, projection } = camera;
    this.isOrthographic = projection[15] === 1;
    this.eye = [world[12], world[13], world[14]];
    const length = Math.hypot(world[8], world[9], world[10]) || 1;
    this.backwards = [world[8] / length, world[9] / length, world[10] / length];
  }

  toView([x, y, z]: Vec3): Vec3 {
    return transformed(this.camera.view, x, y, z);
  }

  /** A position in the world, moved by a step in view space. */
  stepped([x, y, z]: Vec3, [right, up, back]: Vec3): Vec3 {
    const { world: m } = this.camera;
    return [
      x + m[0] * right + m[4] * up + m[8] * back,
      y + m[1] * right + m[5] * up + m[9] * back,
      z + m[2] * right + m[6] * up + m[10] * back,
    ];
  }

  /** Projects a position in view space. */
  project(x: number, y: number, z: number): readonly [number, number] {
    const p = this.camera.projection;
    const w = p[11] * z + p[15];
    return [
      (0.5 + (0.5 * (p[0] * x + p[4] * y + p[8] * z + p[12])) / w) * this.width,
      (0.5 - (0.5 * (p[1] * x + p[5] * y + p[9] * z + p[13])) / w) * this.height,
    ];
  }

  /** Distance of a position in the world from the camera, along the camera's axis. */
  depthOf(x: number, y: number, z: number): number {
    const v = this.camera.view;
    return -(v[2] * x + v[6] * y + v[10] * z + v[14]);
  }

  /** View units per pixel at a depth. */
  unitsPerPixel(depth: number): number {
    return (2 * (this.isOrthographic ? 1 : depth)) / (Math.abs(this.camera.projection[5]) * this.height);
  }

  /** The vector from a position in the world to the near plane, and the factor at which it reaches the eye or the camera plane. */
  wayToEye(x: number, y: number, z: number): { way: Vec3; end: number } {
    const depth = this.depthOf(x, y, z);
    const end = 1 - this.camera.near / depth;
    if (!this.isOrthographic) return { way: [this.eye[0] - x, this.eye[1] - y, this.eye[2] - z], end };
    const [bx, by, bz] = this.backwards;
    return { way: [bx * depth, by * depth, bz * depth], end };
  }

  /** The ray through a pixel, with a direction along which depth grows by 1. */
  rayThrough(px: number, py: number): { origin: Vec3; direction: Vec3 } {
    const { projection: p, world } = this.camera;
    const nx = (2 * px) / this.width - 1;
    const ny = 1 - (2 * py) / this.height;
    const viewAt = (z: number): Vec3 => {
      const w = p[11] * z + p[15];
      return [(nx * w - p[8] * z - p[12]) / p[0], (ny * w - p[9] * z - p[13]) / p[5], z];
    };
    const origin = transformed(world, ...viewAt(0));
    const ahead = transformed(world, ...viewAt(-1));
    return { origin, direction: [ahead[0] - origin[0], ahead[1] - origin[1], ahead[2] - origin[2]] };
  }

  /** Perspective-correct interpolation: the share in space at a share on the picture, from the depths of both ends. */
  shareInSpace(share: number, startDepth: number, endDepth: number): number {
    return this.isOrthographic ? share : (share * startDepth) / (endDepth + share * (startDepth - endDepth));
  }

  contains(px: number, py: number): boolean {
    return px >= 0 && py >= 0 && px <= this.width && py <= this.height;
  }
}

/** The properties of a place that fading depends on. */
export function fadedPlace(world: Vec3, projection: Projection): FadedPlace {
  const view = projection.toView(world);
  const [x, y] = projection.project(...view);
  return { world, depth: -view[2], onPicture: [x / projection.width, 1 - y / projection.height] };
}
