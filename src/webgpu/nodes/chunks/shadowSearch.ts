/**
 * The twin of shaders/chunks/shadowSearch.glsl: how much light passes to a point, and how much of the tone of its shadow is left. A map that
 * compares only tells whether something lies before a depth. So it is asked at rings around the point, within a cone to the lamp; where one of
 * them is dark, the distance of what casts the shadow is found by halving. As wide as the cone is there, so wide is the soft edge.
 */
import { SHADOW_CONSTANTS, SHADOW_SAMPLES } from '../../../look/constants/shadingConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import type { ShadowValues } from '../shadowMaps/ShadowValues.js';

const { Break, dot, float, If, int, Loop, max, min, select, sqrt, vec2, vec4 } = tsl;
const { LIFT, THINNEST, TOWARDS_LAMP } = SHADOW_CONSTANTS;
const { EDGE_SAMPLES, RIM_SAMPLES } = SHADOW_SAMPLES;

/** Rings around a point. */
const RINGS = 4;
/** The steps in which the distance is found: so many that no bands show. */
const HALVINGS = 6;
const LAST_STEP = 1 / 64;
/** Rays are taken up at this share of their length, where a surface that leans to the light does not meet them. */
const WITHIN = 0.25;
/** Seeds in a flower lie at this angle from one another: its cosine and sine. */
const [SEED_COSINE, SEED_SINE] = [-0.73736888, 0.67549029];

/** Share of the tone that is lost over the width that a shadow map covers. */
export const shadowFade: Value = /* @__PURE__ */ hatchingUniform('shadowFade', 'float');
/** Width of the edge, as a share of the distance from what casts it. */
export const shadowSoftness: Value = /* @__PURE__ */ hatchingUniform('shadowSoftness', 'float');

/** Rays from a point to places on a lamp. */
export interface Rays {
  /** Distance at which what casts a shadow is looked for, world units. */
  farthest: Value;
  /** That the map covers at the point. */
  width: Value;
  /** One over the distance of a lamp, 0 for a sun. */
  nearing: Value;
  /** Across the light, unit; and so is `up`. */
  side: Value;
  up: Value;
}

/** How a shadow map is asked. */
interface Asked {
  /** The place on the map of what the ray to the middle of the lamp is at a distance. */
  place(distance: Value): Value;
  /** How it changes to either side. */
  across: readonly [Value, Value];
  /** The depth there. */
  depth(distance: Value): Value;
  /** How much passes what lies beyond a depth, where the map shows a place. */
  passes(place: Value, depth: Value): Value;
}

const times = (count: number): object => ({ start: int(0), end: int(count), type: 'int', condition: '<' });

/** @returns what passes, and what is left, as a vector */
export function shadowSearch(rays: Rays, { mapSize, radius }: ShadowValues, asked: Asked): Value {
  const { place, depth, passes } = asked;
  const [side, up] = asked.across;
  const aside = (way: Value): Value => side.mul(way.x).add(up.mul(way.y)).toVar();
  const told = vec2(1).toVar();
  const opening = shadowSoftness.mul(0.5).toVar();
  const texel = rays.width.div(mapSize.x).toVar();
  const lift = texel.mul(LIFT).toVar();
  const thinnest = max(radius, THINNEST).mul(texel).toVar();
  const darkPlace = place(float(0)).toVar();
  const middle = passes(darkPlace, depth(lift).toVar()).toVar();
  const darkest = middle.toVar();
  const lit = middle.toVar();
  // Distances are found up to that of the lamp; a cone to a lamp opens on the map the faster the nearer it comes.
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
    // The last step is never taken: what lies as far as is looked for has dissolved.
    const faded = shadowFade.mul(caster).div(rays.width.mul(1 - LAST_STEP));
    const left = max(float(1).sub(faded), 0).toVar();
    told.assign(vec2(min(lit, 1), left));
    const isSoft = lit.greaterThanEqual(1e-3).and(left.greaterThan(0)).and(shadowSoftness.greaterThan(0));
    If(isSoft, () => {
      // Places all over the cone, as seeds lie in a flower, the outermost first. What lies nearer than the caster hides the lamp too.
      caster.addAssign(span);
      const edge = max(opening.mul(caster), thinnest).toVar();
      const centre = place(caster).toVar();
      const open = float(0).toVar();
      Loop(times(EDGE_SAMPLES), ({ i }) => {
        // There is no edge if the rim is as dark as the middle.
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
      told.x.assign(open.div(EDGE_SAMPLES));
    });
  });
  return told;
}
