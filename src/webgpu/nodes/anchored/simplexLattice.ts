/**
 * Counterpart of shaders/techniques/anchored/simplexLattice.glsl: the four nearest points of a 3-D simplex lattice of edge 1, and a kernel around
 * each.
 */

import { tsl, type Value } from '../base/values.js';
import { largestComponents } from '../chunks/largestComponents.js';

const { dot, floor, int, ivec3, max, select, uint, uvec3, uvec4, vec3, vec4 } = tsl;

export interface LatticeAnchors {
  /** The vectors from each anchor to the point. */
  offsets: readonly [Value, Value, Value, Value];
  weights: Value;
  /** A random word of each anchor. */
  hashes: Value;
}

/** Odd numbers without common patterns. */
const HASH_STEP = [0x8da6b343, 0xd8163841, 0xcb1ab31f] as const;
/** Their sum, in 32 bits. */
const HASH_STEPS = (HASH_STEP[0] + HASH_STEP[1] + HASH_STEP[2]) >>> 0;

/** A unit step along the axis that a mask marks. */
const stepAlong = (isX: Value, isY: Value): Value =>
  select(isX, uint(HASH_STEP[0]), select(isY, uint(HASH_STEP[1]), uint(HASH_STEP[2])));

/** Random words of the lattice points at cell, cell + second, cell + third and cell + 1. */
function hashAnchors(cell: Value, second: Value, third: Value, lattice: Value): Value {
  const own = uvec3(ivec3(cell))
    .mul(uvec3(...HASH_STEP.map((step) => uint(step))))
    .toVar();
  const toSecond = stepAlong(second.x.greaterThan(0.5), second.y.greaterThan(0.5));
  const toThird = uint(HASH_STEPS).sub(stepAlong(third.x.lessThan(0.5), third.y.lessThan(0.5)));
  const base = own.x
    .add(own.y)
    .add(own.z)
    .add(lattice.mul(uint(0x9e3779b9)));
  const h = uvec4(uint(0), toSecond, toThird, uint(HASH_STEPS)).add(uvec4(base)).toVar();
  const by = (bits: number): Value => h.shiftRight(uvec4(uint(bits)));
  h.assign(h.bitXor(by(16)));
  h.mulAssign(uint(0x7feb352d));
  h.assign(h.bitXor(by(15)));
  h.mulAssign(uint(0x846ca68b));
  return h.bitXor(by(16)).toVar();
}

/** @param lattice index of the lattice; the words of lattices differ */
export function nearestAnchors(x: Value, lattice: Value): LatticeAnchors {
  const cell = floor(x.add(dot(x, vec3(1 / 3)))).toVar();
  const first = x
    .sub(cell)
    .add(dot(cell, vec3(1 / 6)))
    .toVar();
  const { largest: second, twoLargest: third } = largestComponents(first);
  const offsets = [
    first,
    first
      .sub(second)
      .add(1 / 6)
      .toVar(),
    first
      .sub(third)
      .add(1 / 3)
      .toVar(),
    first.sub(0.5).toVar(),
  ] as const;
  // The kernel is zero where an anchor enters or leaves the four nearest: at a squared distance of 0.5.
  const near = max(vec4(0.5).sub(vec4(...offsets.map((offset) => dot(offset, offset)))), 0).toVar();
  const cubes = near.mul(near).mul(near).toVar();
  return {
    offsets,
    weights: cubes.mul(cubes).toVar(),
    hashes: hashAnchors(cell, second, third, uint(int(lattice))),
  };
}
