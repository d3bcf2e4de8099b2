import {
  type AmbientLight,
  type Camera,
  type Color,
  type HemisphereLight,
  type Light,
  type Object3D,
  type PointLight,
  type Scene,
  type Sphere,
  Vector3,
} from 'three';

/** The light that arrives somewhere, as a sum of intensities. A surface that faces light of sum π is blank paper. */
export interface LightSum {
  /** The least light on any surface that faces the lights. */
  least: number;
  /** The greatest; infinite if the intensity of a light does not tell its strength. */
  most: number;
  /** Whether any of the lights is more than ambient. */
  hasForm: boolean;
}

/** Adds up the lights of a scene as they arrive in a sphere, without shadows and cones. */
export function lightOn({ center, radius }: Sphere, scene: Object3D, camera: Camera): LightSum {
  const sum: LightSum = { least: 0, most: 0, hasForm: false };
  const add = (least: number, most: number): void => {
    sum.least += least;
    sum.most += most;
  };
  if ((scene as Scene).environment) {
    add(0, Infinity);
    sum.hasForm = true;
  }
  scene.traverseVisible((object) => {
    if (!('isLight' in object) || !object.layers.test(camera.layers)) return;
    const light = object as Light;
    const full = light.intensity * luminance(light.color);
    if (full > 0 && !(light as Partial<AmbientLight>).isAmbientLight) sum.hasForm = true;
    switch (light.type) {
      case 'AmbientLight':
      case 'DirectionalLight':
        add(full, full);
        break;
      case 'HemisphereLight': {
        const ground = light.intensity * luminance((light as HemisphereLight).groundColor);
        add(Math.min(full, ground), Math.max(full, ground));
        break;
      }
      case 'PointLight':
      case 'SpotLight': {
        const away = new Vector3().setFromMatrixPosition(light.matrixWorld).distanceTo(center);
        const lamp = light as PointLight;
        const least = light.type === 'PointLight' ? lampAt(lamp, full, away + radius) : 0;
        add(least, lampAt(lamp, full, Math.max(away - radius, 0)));
        break;
      }
      default:
        add(0, full > 0 ? Infinity : 0);
    }
  });
  return sum;
}

/** The light of a lamp at a distance, by three's formula. */
function lampAt({ decay, distance: reach }: PointLight, full: number, distance: number): number {
  const left = full / Math.max(distance ** decay, 0.01);
  return reach > 0 ? left * Math.max(1 - (distance / reach) ** 4, 0) ** 2 : left;
}

/** The luminance of a colour in three's linear working space. */
export const luminance = ({ r, g, b }: Color): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;
