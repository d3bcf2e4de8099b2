/**
 * Counterpart of shaders/chunks/shadowSearch.glsl: the light that passes to a point, and the share of its shadow's tone that is left. A
 * shadow map with a comparison sampler only tells whether an occluder lies before a depth. The search samples rings within a cone to the
 * lamp; where one is dark, bisection finds the distance of the occluder, and the width of the cone there is that of the soft edge.
 */
import { SHADOW_CONSTANTS, SHADOW_SAMPLES } from '../../../look/constants/shadingConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import type { ShadowValues } from '../shadowMaps/ShadowValues.js';

const { Break, dot, float, If, int, Loop, max, min, select, sqrt, vec2, vec4 } = tsl;
const { LIFT, THINNEST, TOWARDS_LAMP } = SHADOW_CONSTANTS;
const { EDGE_SAMPLES, RIM_SAMPLES } = SHADOW_SAMPLES;

const RINGS = 4;
/** Steps of the bisection, enough to show no bands. */
const HALVINGS = 6;
const LAST_STEP = 1 / 64;
/** Rays begin at this share of their length, so that a surface at a grazing angle does not hit itself. */
const WITHIN = 0.25;
/** Cosine and sine of the golden angle, by which successive samples are turned. */
const [SEED_COSINE, SEED_SINE] = [-0.73736888, 0.67549029];

/** Share of the tone that is lost over the width of the shadow map. */
export const shadowFade: Value = /* @__PURE__ */ hatchingUniform('shadowFade', 'float');
/** Width of the edge, as a share of the distance from the occluder. */
export const shadowSoftness: Value = /* @__PURE__ */ hatchingUniform('shadowSoftness', 'float');

/** Rays from a point to samples on a lamp. */
export interface Rays {
  /** Greatest distance of an occluder, world units. */
  farthest: Value;
  /** Width of the map at the point. */
  width: Value;
  /** Reciprocal of the distance of a lamp, 0 for a directional light. */
  nearing: Value;
  /** Unit vector across the light, as is `up`. */
  side: Value;
  up: Value;
}

/** Access to a shadow map. */
interface Asked {
  /** The position on the map of the point at a distance along the central ray. */
  place(distance: Value): Value;
  /** Its derivatives to both sides. */
  across: readonly [Value, Value];
  /** The depth of that point. */
  depth(distance: Value): Value;
  /** The light that passes a depth at a position on the map. */
  passes(place: Value, depth: Value): Value;
}

const times = (count: number): object => ({ start: int(0), end: int(count), type: 'int', condition: '<' });

/** @returns vector of the light that passes and the share of the tone that is left */
export function shadowSearch(rays: Rays, { mapSize, radius }: ShadowValues, asked: Asked): Value {
  const { place, depth, passes } = asked;
  const [side, up] = asked.across;
  const aside = (way: Value): Value => side.mul(way.x).add(up.mul(way.y)).toVar();
  const read = vec2(1).toVar();
  const opening = shadowSoftness.mul(0.5).toVar();
  const texel = rays.width.div(mapSize.x).toVar();
  const lift = texel.mul(LIFT).toVar();
  const thinnest = max(radius, THINNEST).mul(texel).toVar();
  const darkPlace = place(float(0)).toVar();
  const middle = passes(darkPlace, depth(lift).toVar()).toVar();
  const darkest = middle.toVar();
  const lit = middle.toVar();
  // Occluders lie no farther away than the lamp. Near a lamp the cone widens fast on the map.
  const farthest = min(rays.farthest, float(TOWARDS_LAMP).div(max(rays.nearing, 1e-6))).toVar();
  const opened = farthest
    .div(float(1).sub(rays.nearing.mul(farthest)))
    .div(3 ** (RINGS - 1))
    .toVar();
  const way = vec2(1, 0).toVar();
  Loop(times(RINGS), () => {
    const ring = opened.div(rays.nearing.mul(opened).add(1)).toVar();
    const centre = place(ring).toVar();
    const wide = max(opening.mul(ring), thinnest).toVar();
    const offset = aside(way.mul(wide).toVar());
    const across = aside(vec2(way.y.negate(), way.x).mul(wide).toVar());
    const before = depth(max(ring.mul(WITHIN), lift).toVar()).toVar();
    const places = [centre.add(offset), centre.sub(offset), centre.add(across), centre.sub(across)];
    const [a, b, c, d] = places.map((there) => passes(there.toVar(), before).toVar());
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
      If(passes(darkPlace, depth(reached).toVar()).lessThan(most), () => {
        caster.addAssign(span);
      });
      span.mulAssign(0.5);
    });
    // The last step is never taken: at the greatest distance the shadow has dissolved.
    const faded = shadowFade.mul(caster).div(rays.width.mul(1 - LAST_STEP));
    const left = max(float(1).sub(faded), 0).toVar();
    read.assign(vec2(min(lit, 1), left));
    const isSoft = lit.greaterThanEqual(1e-3).and(left.greaterThan(0)).and(shadowSoftness.greaterThan(0));
    If(isSoft, () => {
      // Samples all over the cone in a sunflower pattern, outermost first. Occluders nearer than the one found hide the lamp too.
      caster.addAssign(span);
      const edge = max(opening.mul(caster), thinnest).toVar();
      const centre = place(caster).toVar();
      const open = float(0).toVar();
      Loop(times(EDGE_SAMPLES), ({ i }) => {
        // A rim as dark as the middle means no edge.
        If(i.equal(int(RIM_SAMPLES)).and(open.add(middle).lessThan(1e-3)), () => {
          open.assign(0);
          Break();
        });
        const outward = sqrt(float(EDGE_SAMPLES).sub(float(i)).sub(0.5).div(EDGE_SAMPLES)).toVar();
        const there = centre.add(aside(way.mul(edge.mul(outward)).toVar())).toVar();
        open.addAssign(passes(there, depth(max(outward.mul(WITHIN).mul(caster), lift).toVar()).toVar()));
        const { x, y } = way;
        const turned = vec2(x.mul(SEED_COSINE).sub(y.mul(SEED_SINE)), x.mul(SEED_SINE).add(y.mul(SEED_COSINE)));
        way.assign(turned);
      });
      read.x.assign(open.div(EDGE_SAMPLES));
    });
  });
  return read;
}
