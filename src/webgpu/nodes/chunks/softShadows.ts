/** Shadows that widen and dissolve with the distance from what casts them. */
import type { Light, LightShadow } from 'three';
import { SHADOW_CONSTANTS, SHADOW_SAMPLES } from '../../../look/constants/shadingConstants.js';
import { hasPlace, valuesFor } from '../base/lights.js';
import { hatchingUniform } from '../base/uniforms.js';
import { threeNodes, tsl, type Value } from '../base/values.js';
import { passes, type ShadowMap, type ShadowValues, shadowValuesFor } from './shadowFilters.js';

const { abs, Break, cameraViewMatrix, cross, dot, float, If, int, length, Loop, max, min, mix, normalize } = tsl;
const { positionView, positionWorld, select, sqrt, vec2, vec3, vec4 } = tsl;
const { FARTHEST_CASTER, LIFT, OVERHEAD, THINNEST, TOWARDS_LAMP } = SHADOW_CONSTANTS;
const { EDGE_SAMPLES, RIM_SAMPLES } = SHADOW_SAMPLES;
const { lightShadowMatrix } = threeNodes;

/**
 * Counterpart of shaders/chunks/shadowSearch.glsl: the light that passes to a point, and the share of its shadow's tone that is left. A
 * shadow map with a comparison sampler only tells whether an occluder lies before a depth. The search samples rings within a cone to the
 * lamp; where one is dark, bisection finds the distance of the occluder, and the width of the cone there is that of the soft edge.
 */

const RINGS = 4;
/** Steps of the bisection, enough to show no bands. */
const HALVINGS = 6;
const LAST_STEP = 1 / 64;
/** Rays begin at this share of their length, so that a surface at a grazing angle does not hit itself. */
const WITHIN = 0.25;
/** Cosine and sine of the golden angle, by which successive samples are turned. */
const [SEED_COSINE, SEED_SINE] = [-0.73736888, 0.67549029];

export const shadowFade: Value = /* @__PURE__ */ hatchingUniform('shadowFade', 'float');
export const shadowSoftness: Value = /* @__PURE__ */ hatchingUniform('shadowSoftness', 'float');

/** Rays from a point to samples on a lamp. */
export interface Rays {
  /** Greatest distance of an occluder, world units. */
  farthest: Value;
  /** Width of the map at the point. */
  width: Value;
  /** Reciprocal of the distance of a lamp, 0 for a directional light. */
  nearing: Value;
  /** The point on the map: homogeneous on a flat one, the vector from the light on a cube. */
  at: Value;
  /** Its change per unit of distance along the central ray. */
  towards: Value;
  /** Its changes per unit to both sides. */
  across: readonly [Value, Value];
  /** Numerator and denominator of the depth at the point, and their changes per unit of distance. */
  depth: readonly [Value, Value, Value, Value];
}

const depthAlong = ({ depth: [above, below, addedAbove, addedBelow] }: Rays, distance: Value): Value =>
  above
    .add(distance.mul(addedAbove))
    .div(below.add(distance.mul(addedBelow)))
    .toVar();

const times = (count: number): object => ({ start: int(0), end: int(count), type: 'int', condition: '<' });

/** @returns vector of the light that passes and the share of the tone that is left */
export function shadowSearch(map: ShadowMap, values: ShadowValues, rays: Rays): Value {
  const [side, up] = rays.across;
  const depth = (distance: Value): Value => depthAlong(rays, distance);
  const passesAt = (place: Value, before: Value): Value => passes(map, values, place, before);
  const aside = (way: Value): Value => side.mul(way.x).add(up.mul(way.y)).toVar();
  const read = vec2(1).toVar();
  const opening = shadowSoftness.mul(0.5).toVar();
  const texel = rays.width.div(values.mapSize.x).toVar();
  const lift = texel.mul(LIFT).toVar();
  const thinnest = max(values.radius, THINNEST).mul(texel).toVar();
  const darkPlace = rays.at.toVar();
  const middle = passesAt(darkPlace, depth(lift)).toVar();
  const darkest = middle.toVar();
  const lit = middle.toVar();
  // Occluders lie no farther away than the lamp. Near a lamp the cone widens fast on the map.
  const farthest = min(rays.farthest, float(TOWARDS_LAMP).div(max(rays.nearing, 1e-6))).toVar();
  const opened = farthest
    .div(rays.nearing.mul(farthest).oneMinus())
    .div(3 ** (RINGS - 1))
    .toVar();
  const way = vec2(1, 0).toVar();
  Loop(times(RINGS), () => {
    const ring = opened.div(rays.nearing.mul(opened).add(1)).toVar();
    const centre = rays.at.add(rays.towards.mul(ring)).toVar();
    const wide = max(opening.mul(ring), thinnest).toVar();
    const offset = aside(way.mul(wide).toVar());
    const across = aside(vec2(way.y.negate(), way.x).mul(wide).toVar());
    const before = depth(max(ring.mul(WITHIN), lift).toVar());
    const places = [centre.add(offset), centre.sub(offset), centre.add(across), centre.sub(across)];
    const [a, b, c, d] = places.map((there) => passesAt(there.toVar(), before).toVar());
    lit.addAssign(dot(vec4(a, b, c, d), vec4(1)));
    const darker = min(min(a, c), min(b, d)).toVar();
    If(darker.lessThan(darkest.sub(1e-3)), () => {
      darkest.assign(darker);
      const negative = select(c.equal(darker), across, across.negate());
      const shift = select(a.equal(darker), offset, select(b.equal(darker), offset.negate(), negative));
      darkPlace.assign(centre.add(shift));
    });
    opened.mulAssign(3);
    way.assign(vec2(way.x.sub(way.y), way.x.add(way.y)).mul(Math.SQRT1_2));
  });
  If(lit.lessThanEqual(4 * RINGS + 0.999), () => {
    const most = darkest.mul(0.5).add(0.5).toVar();
    const caster = float(0).toVar();
    const span = farthest.mul(0.5).toVar();
    Loop(times(HALVINGS), () => {
      const reached = max(caster.add(span), lift).toVar();
      If(passesAt(darkPlace, depth(reached)).lessThan(most), () => {
        caster.addAssign(span);
      });
      span.mulAssign(0.5);
    });
    // The last step is never taken: at the greatest distance the shadow has dissolved.
    const faded = shadowFade.mul(caster).div(rays.width.mul(1 - LAST_STEP));
    const left = max(faded.oneMinus(), 0).toVar();
    read.assign(vec2(min(lit, 1), left));
    const isSoft = lit.greaterThanEqual(1e-3).and(left.greaterThan(0)).and(shadowSoftness.greaterThan(0));
    If(isSoft, () => {
      // Samples all over the cone in a sunflower pattern, outermost first. Occluders nearer than the one found hide the lamp too.
      caster.addAssign(span);
      const edge = max(opening.mul(caster), thinnest).toVar();
      const centre = rays.at.add(rays.towards.mul(caster)).toVar();
      const open = float(0).toVar();
      Loop(times(EDGE_SAMPLES), ({ i }) => {
        // A rim as dark as the middle means no edge.
        If(i.equal(int(RIM_SAMPLES)).and(open.add(middle).lessThan(1e-3)), () => {
          open.assign(0);
          Break();
        });
        const outward = sqrt(float(EDGE_SAMPLES).sub(float(i)).sub(0.5).div(EDGE_SAMPLES)).toVar();
        const there = centre.add(aside(way.mul(edge.mul(outward)).toVar())).toVar();
        open.addAssign(passesAt(there, depth(max(outward.mul(WITHIN).mul(caster), lift).toVar())));
        const { x, y } = way;
        const turned = vec2(x.mul(SEED_COSINE).sub(y.mul(SEED_SINE)), x.mul(SEED_SINE).add(y.mul(SEED_COSINE)));
        way.assign(turned);
      });
      read.x.assign(open.div(EDGE_SAMPLES));
    });
  });
  return read;
}

/**
 * Counterpart of shaders/chunks/softShadows.glsl: shadows whose edges widen and whose tone dissolves with the distance from the occluder.
 */

export const shadowTone: Value = /* @__PURE__ */ hatchingUniform('shadowTone', 'float');

/**
 * The share of the tone of all shadows that is left. @param taken luminance that they take @param lost the part of it that has dissolved
 */
export const shadowLeft = (taken: Value, lost: Value): Value =>
  select(taken.greaterThan(0), lost.div(max(taken, 1e-20)).oneMinus(), float(1));

/** Unit vectors across the light, to both sides. */
function besides(toLight: Value): readonly [Value, Value] {
  const upright = select(abs(toLight.y).lessThan(OVERHEAD), vec3(0, 1, 0), vec3(1, 0, 0));
  const side = normalize(cross(toLight, upright)).toVar();
  return [side, cross(toLight, side).toVar()];
}

const farthestCaster = (width: Value): Value => width.div(max(shadowFade, 1 / FARTHEST_CASTER)).toVar();

/** Transforms a direction from view to world space. */
const inWorld = (direction: Value): Value => vec4(direction, 0).mul(cameraViewMatrix).xyz.toVar();

/** Light that passes a flat map, and the share of tone left. @param matrix from world to map @param toLight unit, world space */
function flatShadow(map: ShadowMap, matrix: Value, toLight: Value, values: ShadowValues): Value {
  const read = vec2(1).toVar();
  const at = matrix.mul(vec4(positionWorld, 1)).toVar();
  const away = abs(at.xyz.div(at.w).sub(0.5)).toVar();
  const isOnMap = at.w.greaterThan(0).and(max(max(away.x, away.y), away.z).lessThanEqual(0.5));
  If(isOnMap, () => {
    // The width of the map across the light at this distance is at.w divided by the length of this vector.
    const [row, lastRow] = (['x', 'w'] as const).map((c) => vec3(...[0, 1, 2].map((i) => matrix.element(i)[c])));
    const towards = matrix.mul(vec4(toLight, 0)).toVar();
    const width = at.w.div(length(row.sub(lastRow.mul(0.5)))).toVar();
    const [side, up] = besides(toLight).map((way) => matrix.mul(vec4(way, 0)).toVar());
    const found = shadowSearch(map, values, {
      farthest: farthestCaster(width),
      width,
      nearing: max(towards.w.negate().div(at.w), 0).toVar(),
      at,
      towards,
      across: [side, up],
      depth: [at.z, at.w, towards.z, towards.w],
    });
    read.assign(found);
  });
  return read;
}

/** @param fromLight from the light to the point, world space */
function cubeShadow(map: ShadowMap, fromLight: Value, values: ShadowValues): Value {
  const size = abs(fromLight).toVar();
  const lightDistance = length(fromLight).toVar();
  const toLight = fromLight.div(lightDistance).negate().toVar();
  const width = max(max(size.x, size.y), size.z).mul(2).toVar();
  return shadowSearch(map, values, {
    farthest: farthestCaster(width),
    width,
    nearing: float(1).div(lightDistance).toVar(),
    at: fromLight,
    towards: toLight,
    across: besides(toLight),
    depth: [lightDistance, float(1), float(-1), float(0)],
  });
}

/**
 * The soft shadow of one light at the fragment.
 *
 * @param filtered the light that passes with three.js' filter
 */
export function readSoftShadow(
  light: Light & { shadow: LightShadow },
  map: ShadowMap,
  filtered: () => Value,
): { shadow: Value; toneLeft: Value } {
  const { direction, position } = valuesFor(light);
  const values = shadowValuesFor(light.shadow);
  const way = (hasPlace(light) ? position.sub(positionView) : direction).toVar();
  const read = vec2(1).toVar();
  const shadow = float(1).toVar();
  If(max(shadowFade, shadowSoftness).greaterThan(0), () => {
    const matrix = lightShadowMatrix(light as never) as unknown as Value;
    const found = map.isCube
      ? cubeShadow(map, inWorld(way.negate()), values)
      : flatShadow(map, matrix, inWorld(normalize(way)), values);
    read.assign(found);
  });
  If(shadowSoftness.greaterThan(0), () => {
    shadow.assign(mix(1, read.x, values.intensity));
  }).Else(() => {
    shadow.assign(filtered());
  });
  return { shadow, toneLeft: read.y };
}
