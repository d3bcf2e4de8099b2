import { type Matrix4, Vector3 } from 'three';

type Vec3 = [x: number, y: number, z: number];

/** A camera of a file. */
export interface FileCamera {
  name: string;
  position: Vec3;
  /** Unit: where it looks to, and what is up in its picture. */
  forwards: Vec3;
  up: Vec3;
  /** Half the height of its picture: at a distance of 1, or everywhere if it is orthographic. */
  high: number;
  isOrthographic: boolean;
  /** How many times wider than high its picture is; undefined if that is left open. */
  aspect: number | undefined;
}

/** A light of a file. */
export interface FileLight {
  kind: 'directional' | 'point' | 'spot';
  /** Luminance times intensity, as the file has it. */
  intensity: number;
  position: Vec3;
  /** Unit: where it shines to. */
  forwards: Vec3;
  /** Half the width of a spot, in radians. */
  angle: number;
}

/** What a file offers beside its model. */
export interface ModelExtras {
  cameras: readonly FileCamera[];
  lights: readonly FileLight[];
  /** The names of the variants of its materials. */
  variants: readonly string[];
}

export const NO_EXTRAS: ModelExtras = { cameras: [], lights: [], variants: [] };

/** Cameras and lights as their model is moved, turned and scaled evenly. */
export function movedExtras(extras: ModelExtras, matrix: Matrix4): ModelExtras {
  const vector = new Vector3();
  const scale = matrix.getMaxScaleOnAxis();
  const place = (position: Vec3): Vec3 => vector.fromArray(position).applyMatrix4(matrix).toArray();
  const turn = (way: Vec3): Vec3 => vector.fromArray(way).transformDirection(matrix).toArray();
  return {
    ...extras,
    cameras: extras.cameras.map((camera) => ({
      ...camera,
      position: place(camera.position),
      forwards: turn(camera.forwards),
      up: turn(camera.up),
      high: camera.isOrthographic ? scale * camera.high : camera.high,
    })),
    lights: extras.lights.map((light) => ({
      ...light,
      position: place(light.position),
      forwards: turn(light.forwards),
    })),
  };
}
