import {
  type DirectionalLight,
  type HemisphereLight,
  type Light,
  type LightProbe,
  Matrix4,
  type PointLight,
  type Scene,
  type SpotLight,
  Vector3,
} from 'three';
import { radianceAround, type Surroundings } from '../../look/surroundings.js';
import { luminanceOf, smoothstep } from '../../look/vectors.js';
import { harmonicsOf } from './environmentHarmonics.js';
import type { SceneContents } from './SceneContents.js';

/** A light with a direction, as numbers in world space. */
interface Lamp {
  luminance: number;
  /** The unit vector to a distant light, or the position of a positional one. */
  at: Vector3;
  isFar: boolean;
  distance: number;
  decay: number;
  /** Of a spot light: the unit vector from its target to it, and the cosines at which its cone ends and at which its light is full. */
  axis: Vector3 | undefined;
  outer: number;
  inner: number;
}

/** The light that arrives at a point, as radiances of a white surface. */
export interface Arriving {
  /** Light from lamps. */
  direct: number;
  /** Light from all around. */
  indirect: number;
  /** The light of lamps that fully reflecting surroundings would reflect. */
  reflected: number;
}

const positionOf = (object: { matrixWorld: Matrix4 }): Vector3 =>
  new Vector3().setFromMatrixPosition(object.matrixWorld);

/** The lights of a scene as they arrive at points with normals, computed as in the shaders, but without shadows. */
export class LightsAround {
  private readonly lamps: Lamp[] = [];
  /** The light without a position: ambient light, skies, probes and the environment. */
  readonly surroundings: Surroundings;
  private readonly toLamp = new Vector3();

  constructor({ lights, scene }: Pick<SceneContents, 'lights' | 'scene'>) {
    const { environment = null, environmentIntensity = 1, environmentRotation } = scene as Scene;
    this.surroundings = { ambient: 0, skies: [], probes: new Float64Array(9), environment: null };
    if (environment) {
      const into = new Matrix4();
      if (environmentRotation) into.makeRotationFromEuler(environmentRotation).transpose();
      const { elements: e } = into;
      this.surroundings.environment = {
        harmonics: harmonicsOf(environment),
        intensity: environmentIntensity,
        into: [
          [e[0], e[4], e[8]],
          [e[1], e[5], e[9]],
          [e[2], e[6], e[10]],
        ],
      };
    }
    for (const light of lights) this.add(light);
  }

  private add(light: Light): void {
    const full = light.intensity * luminanceOf(light.color);
    const { surroundings } = this;
    if ('isAmbientLight' in light) surroundings.ambient += full;
    else if ('isHemisphereLight' in light) {
      const ground = light.intensity * luminanceOf((light as HemisphereLight).groundColor);
      surroundings.skies.push({
        up: positionOf(light).normalize().toArray(),
        mean: (full + ground) / 2,
        difference: (full - ground) / 2,
      });
    } else if ('isLightProbe' in light) {
      const { coefficients } = (light as LightProbe).sh;
      for (const [i, { x, y, z }] of coefficients.entries())
        surroundings.probes[i] += light.intensity * (0.2126 * x + 0.7152 * y + 0.0722 * z);
    } else if ('isDirectionalLight' in light) {
      const at = positionOf(light)
        .sub(positionOf((light as DirectionalLight).target))
        .normalize();
      this.lamps.push({ ...FAR, luminance: full, at });
    } else if ('isPointLight' in light || 'isSpotLight' in light) this.lamps.push(lampAt(light as PointLight, full));
  }

  /**
   * Writes the light that arrives at a point with a normal, in world space. Allocates nothing.
   *
   * @param isHalfLambert whether light wraps around the surface (half Lambert)
   */
  arriveAt(position: Vector3, normal: Vector3, isHalfLambert: boolean, result: Arriving): void {
    let [direct, reflected] = [0, 0];
    for (const lamp of this.lamps) {
      let { luminance: sent, at: toLamp } = lamp;
      let cone = 1;
      if (!lamp.isFar) {
        toLamp = this.toLamp.subVectors(lamp.at, position);
        const distance = toLamp.length();
        toLamp.divideScalar(distance);
        sent *= attenuation(distance, lamp);
        if (lamp.axis) cone = smoothstep(lamp.outer, Math.max(lamp.inner, lamp.outer + HARD), toLamp.dot(lamp.axis));
      }
      const cosine = normal.dot(toLamp);
      direct += sent * cone * (isHalfLambert ? (0.5 * cosine + 0.5) ** 2 : Math.max(cosine, 0));
      reflected += sent * (0.5 - 0.5 * cosine);
    }
    result.direct = direct / Math.PI;
    result.indirect = radianceAround(this.surroundings, normal.x, normal.y, normal.z);
    result.reflected = reflected / Math.PI;
  }
}

/** The least width of the edge of a cone, as a difference of cosines. */
const HARD = 1e-9;

const FAR = { isFar: true, distance: 0, decay: 0, axis: undefined, outer: 0, inner: 0 } as const;

function lampAt(light: PointLight | SpotLight, full: number): Lamp {
  const { distance, decay } = light;
  const lamp = { ...FAR, isFar: false, luminance: full, at: positionOf(light), distance, decay };
  if (!('target' in light)) return lamp;
  const axis = positionOf(light).sub(positionOf(light.target)).normalize();
  const outer = Math.cos(light.angle);
  return { ...lamp, axis, outer, inner: Math.cos(light.angle * (1 - light.penumbra)) };
}

/** The attenuation of a lamp at a distance, by three's formula. */
function attenuation(length: number, { distance, decay }: Lamp): number {
  const left = 1 / Math.max(length ** decay, 0.01);
  return distance > 0 ? left * Math.max(0, Math.min(1, 1 - (length / distance) ** 4)) ** 2 : left;
}
