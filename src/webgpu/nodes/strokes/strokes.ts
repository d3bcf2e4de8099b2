/** Strokes read from a tonal art map, anchored at the points of a lattice. */
import type { HatchingTechnique } from '../../../look/hatchingProperties.js';
import { largestComponents } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { inkAt as dryInkAt } from '../chunks/dryMedia.js';
import { type HatchField, inkAt } from '../chunks/ink.js';
import {
  blendedField,
  chooseLevel,
  levelByDepth,
  levelFor,
  type ThresholdLevel,
  thresholdMapSize,
  tilesPerObjectUnit,
} from '../chunks/thresholdMap.js';
import { vUnitsPerPixel } from './emit.js';
import { latticeSpacing } from './layers.js';
import type { HatchingParameters } from './read.js';

const { ceil, dot, exp2, float, floor, fwidth, If, int, inverseSqrt, ivec3, log2, max, select, smoothstep, uint } = tsl;
const { uvec3, uvec4, vec2, vec3, vec4 } = tsl;

/**
 * Counterpart of shaders/techniques/strokes/simplexLattice.glsl: the four nearest points of a 3-D simplex lattice of edge 1, and a
 * kernel around each.
 */

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
function nearestAnchors(x: Value, lattice: Value): LatticeAnchors {
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

/**
 * Counterpart of shaders/techniques/strokes/strokes.glsl: strokes anchored in object space. The four nearest points of a lattice that is
 * fixed to the object sample the threshold map; the fields are blended, and then compared with the tone once.
 */

const screenSpaceShare = /* @__PURE__ */ hatchingUniform('screenSpaceShare', 'float');

/** Octaves between the lattices of strokes that are sized on the screen. */
const LATTICE_OCTAVES = 1;
/** The last part of an octave, in which a lattice fades into the next. */
const LATTICE_FADE = 0.75;
/** Octaves by which strokes may crowd at grazing angles before coarser levels of the map are used. */
const FREE_CROWDING = 1;

/** The choices that the program depends on. */
export interface StrokeDefines {
  /** Whether any strokes are sized on the screen. */
  isSizedOnScreen: boolean;
  /** Whether directions are known up to their sign only. */
  isUpToSign: boolean;
  technique: HatchingTechnique;
  /** The pixel of the render target, counted from the lower left. */
  pixel: Value;
}

/** The g of one lattice's blended field. */
function latticeField(h: HatchingParameters, lattice: Value, level: ThresholdLevel, isUpToSign: boolean): Value {
  const scale = tilesPerObjectUnit.mul(exp2(lattice.mul(LATTICE_OCTAVES))).div(latticeSpacing);
  const { offsets, weights, hashes } = nearestAnchors(h.point.mul(scale).toVar(), lattice);
  const bitsFrom = (shift: number, mask: number): Value =>
    vec4(hashes.shiftRight(uvec4(shift)).bitAnd(uvec4(mask))).toVar();
  // Strokes stay where B turns into −B: the map is symmetric about its centre, and is shifted by half tiles only.
  const shiftU = isUpToSign ? bitsFrom(0, 1).mul(0.5) : bitsFrom(0, 0xffff).mul(1 / 65536);
  const shiftV = isUpToSign ? bitsFrom(16, 1).mul(0.5) : bitsFrom(16, 0xffff).mul(1 / 65536);
  const along = vec4(...offsets.map((offset) => dot(h.uAxis, offset))).mul(latticeSpacing);
  const across = vec4(...offsets.map((offset) => dot(h.vAxis, offset))).mul(latticeSpacing);
  // One bit of each word mirrors its strokes.
  const mirrored = bitsFrom(15, 1).mul(2).oneMinus();
  const u = along.mul(mirrored).add(shiftU).toVar();
  const v = across.add(shiftV).toVar();
  const places = (['x', 'y', 'z', 'w'] as const).map((c) => vec2(u[c], v[c]));
  return blendedField(places, weights, level);
}

/** Octaves by which strokes lie closer on the screen than face on. */
function foreshortenedOctaves(lean: Value): Value {
  const facing = lean.z.mul(lean.z).toVar();
  const share = facing.div(max(facing.add(lean.y.mul(lean.y)), 1e-20));
  return log2(max(share, 1e-4)).mul(-0.5).toVar();
}

/** @param isInked whether anything will be printed; otherwise the map is not sampled */
function anchoredField(
  h: HatchingParameters,
  isInked: Value,
  { isSizedOnScreen, isUpToSign }: StrokeDefines,
): { field: HatchField; crowding: Value } {
  // Octaves by which the map at `tilesPerObjectUnit` is magnified: above 0 near, below 0 far away.
  const magnification = levelByDepth(thresholdMapSize, vUnitsPerPixel).negate().toVar();
  const foreshortened = foreshortenedOctaves(h.lean);
  const beyond = max(foreshortened.sub(FREE_CROWDING), 0);
  const wanted = isSizedOnScreen ? screenSpaceShare.mul(magnification).div(LATTICE_OCTAVES).toVar() : float(0);
  const lattice = isSizedOnScreen ? ceil(wanted).toVar() : float(0).toVar();
  const faceOn = lattice.mul(LATTICE_OCTAVES).sub(magnification).toVar();
  const octaves = faceOn.add(beyond).toVar();
  const g = float(0).toVar();
  const mixing = float(0).toVar();
  const add = (i: number, share: Value | number): void => {
    const level = chooseLevel(levelFor(octaves.add(i * LATTICE_OCTAVES)).toVar());
    g.addAssign(latticeField(h, lattice.add(i).toVar(), level, isUpToSign).mul(share));
    mixing.assign(max(mixing, level.mixing));
  };
  if (!isSizedOnScreen) If(isInked, () => add(0, 1));
  else {
    const fade = smoothstep(1 - LATTICE_FADE, 1, lattice.sub(wanted).oneMinus()).toVar();
    If(isInked, () => {
      add(0, fade.oneMinus());
      If(fade.greaterThan(0), () => add(1, fade));
    });
    // The fields are independent: their variances add.
    g.mulAssign(inverseSqrt(fade.mul(2).mul(fade.oneMinus()).oneMinus()));
  }
  const crowding = faceOn.add(foreshortened).sub(levelFor(octaves)).toVar();
  return { field: { g, mixing }, crowding };
}

/** Must not be called in branches, since the edges of strokes need screen-space derivatives. */
export function hatchLayer(h: HatchingParameters, tone: Value, defines: StrokeDefines): Value {
  const isInked = tone.add(fwidth(tone)).greaterThan(0).toVar();
  const { field, crowding } = anchoredField(h, isInked, defines);
  return defines.technique === 'dryMedia'
    ? dryInkAt(field, tone, crowding, defines.pixel)
    : inkAt(field, tone, crowding);
}
