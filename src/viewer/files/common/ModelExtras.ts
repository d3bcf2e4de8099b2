import { type Matrix4, Vector3 } from 'three';

type Vec3 = [x: number, y: number, z: number];

/** A camera of a file. */
export interface FileCamera {
  name: string;
  position: Vec3;
  /** Unit vectors: the viewing direction, and up in the picture. */
  forwards: Vec3;
  up: Vec3;
  /** Half the height of the picture: at distance 1, or at any distance if it is orthographic. */
  high: number;
  isOrthographic: boolean;
  /** Aspect of the picture (width / height); undefined if the file leaves it open. */
  aspect: number | undefined;
}

/** A light of a file. */
export interface FileLight {
  kind: 'directional' | 'point' | 'spot';
  /** Luminance of the colour times the intensity of the file. */
  intensity: number;
  position: Vec3;
  /** Unit vector of the direction in which it shines. */
  forwards: Vec3;
  /** Half the cone angle of a spot light, in radians. */
  angle: number;
}

/** Cameras, lights and material variants of a file. */
export interface ModelExtras {
  cameras: readonly FileCamera[];
  lights: readonly FileLight[];
  /** Names of the material variants. */
  variants: readonly string[];
}

export const NO_EXTRAS: ModelExtras = { cameras: [], lights: [], variants: [] };

/** Transforms cameras and lights by the matrix of their model, which scales uniformly. */
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
