/** The scene's lights and the shadows that they cast, as values at a fragment or a vertex. */
import {
  Color,
  type HemisphereLight,
  type Light,
  type LightShadow,
  type PointLight,
  type SpotLight,
  Vector3,
} from 'three';
import type { LightsNode, NodeBuilder } from 'three/webgpu';
import type { ShadowLookup } from '../chunks/shadowFilters.js';
import { lightLuminance } from './maths.js';
import { threeNodes, tsl, type Value } from './values.js';

const { clamp, dot, float, length, max, pow, select, smoothstep, vec3 } = tsl;
const { renderGroup, uniform } = threeNodes;

/** The lights of the scene. */
export const lightsOf = (builder: NodeBuilder): readonly Light[] =>
  (builder as NodeBuilder & { lightsNode: LightsNode | null }).lightsNode?.getLights() ?? [];

/** Whether a light has a position. */
export const hasPlace = (light: Light): boolean => 'isPointLight' in light || 'isSpotLight' in light;

/** The lights that have a direction: all but hemisphere lights. */
export const directedLights = (lights: readonly Light[]): Light[] =>
  lights.filter((light) => 'isDirectionalLight' in light || hasPlace(light));

/** A light that casts shadows, at a fragment. */
export interface ReceivedShadow {
  light: Light & { shadow: LightShadow };
  /** The share of the light that arrives. */
  shadow: Value;
  /** The share of the tone of its shadow that is left; null where shadows do not dissolve. */
  toneLeft: Value | null;
  /** Whether it is so shadowed that strokes no longer follow it; null where they always do. */
  isShadowed: Value | null;
  /** How its map is read elsewhere; null for a map that is not known. */
  lookup: ShadowLookup | null;
  /** The radiance that the light sends; null where no strokes end at shadows. */
  sent: Value | null;
}

/**
 * Counterpart of shaders/perFragment/fullShadow.glsl: whether no directed light arrives; null if some light casts no shadows and always
 * does.
 */
export function isInFullShadow(lights: readonly Light[], receivedShadows: readonly ReceivedShadow[]): Value | null {
  const shadowed = receivedShadows.flatMap(({ isShadowed }) => isShadowed ?? []);
  if (shadowed.length === 0 || shadowed.length < directedLights(lights).length) return null;
  return shadowed.reduce((all, one) => all.and(one)).toVar();
}

/**
 * Counterpart of shaders/chunks/meanLight.glsl. Reads the lights of the scene itself, since three.js' light nodes work in fragments only.
 */

const place = /* @__PURE__ */ new Vector3();

/** Uniforms of a light, shared by all programs. */
export interface LightValues {
  color: Value;
  ground: Value;
  /** View space. */
  position: Value;
  /** Unit direction to the light, view space. */
  direction: Value;
  reach: Value;
  decay: Value;
  coneCosine: Value;
  penumbraCosine: Value;
}

const valuesOf = /* @__PURE__ */ new WeakMap<Light, LightValues>();

export function valuesFor(light: Light): LightValues {
  const known = valuesOf.get(light);
  if (known) return known;
  const number = (read: () => number): Value =>
    uniform(0).setGroup(renderGroup).onRenderUpdate(read) as unknown as Value;
  const color = (read: () => Color): Value =>
    uniform(new Color())
      .setGroup(renderGroup)
      .onRenderUpdate((_frame, self) => {
        self.value.copy(read()).multiplyScalar(light.intensity);
      }) as unknown as Value;
  const inView = (write: (target: Vector3, camera: { matrixWorldInverse: Light['matrixWorld'] }) => void): Value =>
    uniform(new Vector3())
      .setGroup(renderGroup)
      .onRenderUpdate(({ camera }, self) => {
        if (camera) write(self.value, camera);
      }) as unknown as Value;
  const { angle = 0, penumbra = 0 } = light as Partial<SpotLight>;
  const made: LightValues = {
    color: color(() => light.color),
    ground: color(() => (light as HemisphereLight).groundColor ?? light.color),
    position: inView((target, camera) => {
      target.setFromMatrixPosition(light.matrixWorld).applyMatrix4(camera.matrixWorldInverse);
    }),
    direction: inView((target, camera) => {
      target.setFromMatrixPosition(light.matrixWorld);
      const aim = (light as SpotLight).target as SpotLight['target'] | undefined;
      if (aim) target.sub(place.setFromMatrixPosition(aim.matrixWorld));
      target.transformDirection(camera.matrixWorldInverse);
    }),
    reach: number(() => (light as PointLight).distance ?? 0),
    decay: number(() => (light as PointLight).decay ?? 0),
    coneCosine: number(() => Math.cos((light as SpotLight).angle ?? angle)),
    penumbraCosine: number(() =>
      Math.cos(((light as SpotLight).angle ?? angle) * (1 - ((light as SpotLight).penumbra ?? penumbra))),
    ),
  };
  valuesOf.set(light, made);
  return made;
}

/** Attenuation of a light over a distance, as in three.js. */
export function fallOff(away: Value, { reach, decay }: LightValues): Value {
  const left = float(1)
    .div(max(pow(away, decay), 0.01))
    .toVar();
  const share = away.div(max(reach, 1e-20)).toVar();
  const edge = clamp(share.mul(share).mul(share).mul(share).oneMinus(), 0, 1).toVar();
  return select(reach.greaterThan(0), left.mul(edge).mul(edge), left);
}

/**
 * The direction from which light comes at a point in view space: the mean of all lights, weighted by luminance; not of unit length.
 *
 * @param lights of the scene
 */
export function meanLight(viewPosition: Value, lights: readonly Light[]): Value {
  const sum = vec3(0).toVar();
  for (const light of lights) {
    const values = valuesFor(light);
    if ('isDirectionalLight' in light) {
      sum.addAssign(values.direction.mul(lightLuminance(values.color)));
    } else if ('isHemisphereLight' in light) {
      const difference = lightLuminance(values.color).sub(lightLuminance(values.ground));
      sum.addAssign(values.direction.mul(difference).mul(0.5));
    } else if ('isPointLight' in light || 'isSpotLight' in light) {
      const way = values.position.sub(viewPosition).toVar();
      const away = length(way).toVar();
      const direction = way.div(away).toVar();
      const left = fallOff(away, values).toVar();
      if ('isSpotLight' in light) {
        left.mulAssign(smoothstep(values.coneCosine, values.penumbraCosine, dot(direction, values.direction)));
      }
      sum.addAssign(direction.mul(lightLuminance(values.color).mul(left)));
    }
  }
  return sum;
}
