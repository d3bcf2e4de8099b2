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

/** The light that arrives somewhere, as a sum of intensities. π is what brings a surface that faces it to blank paper. */
export interface LightSum {
  /** At least this much arrives everywhere that faces the lights. */
  least: number;
  /** And nowhere more. Infinite where a light cannot be told by its intensity. */
  most: number;
  /** Whether any of it is more than ambient. */
  hasForm: boolean;
}

/** Adds up the lights of a scene as they arrive in a sphere, shadows and cones aside. */
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

/** What is left of a lamp's light at a distance, as three.js has it. */
function lampAt({ decay, distance: reach }: PointLight, full: number, distance: number): number {
  const left = full / Math.max(distance ** decay, 0.01);
  return reach > 0 ? left * Math.max(1 - (distance / reach) ** 4, 0) ** 2 : left;
}

/** Of a colour in the linear space that three.js keeps it in. */
export const luminance = ({ r, g, b }: Color): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;
