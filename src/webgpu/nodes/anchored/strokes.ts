/**
 * Counterpart of shaders/techniques/anchored/strokes.glsl: strokes anchored in object space. The four nearest points of a lattice that is
 * fixed to the object sample the threshold map; the fields are blended, and then compared with the tone once.
 */
import type { Medium } from '../../../look/hatchingProperties.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { inkAt as dryInkAt } from '../chunks/dryMedium.js';
import { type HatchField, inkAt } from '../chunks/ink.js';
import { levelByDepth, tilesPerUnit } from '../chunks/levelByDepth.js';
import { blendedField, chooseLevel, levelFor, type ThresholdLevel, thresholdMapSize } from '../chunks/thresholdMap.js';
import { anchorSpacing } from './layers.js';
import type { HatchingParameters } from './read.js';
import { nearestAnchors } from './simplexLattice.js';
import { vUnitsPerPixel } from './varyings.js';

const { ceil, dot, exp2, float, fwidth, If, inverseSqrt, log2, max, smoothstep, uvec4, vec2, vec4 } = tsl;

/** 0: strokes sized on the object, 1: on the screen. */
const sizedOnScreen = /* @__PURE__ */ hatchingUniform('sizedOnScreen', 'float');

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
  medium: Medium;
  /** The pixel of the render target, counted from the lower left. */
  pixel: Value;
}

/** The g of one lattice's blended field. */
function latticeField(h: HatchingParameters, lattice: Value, level: ThresholdLevel, isUpToSign: boolean): Value {
  const scale = tilesPerUnit.mul(exp2(lattice.mul(LATTICE_OCTAVES))).div(anchorSpacing);
  const { offsets, weights, hashes } = nearestAnchors(h.point.mul(scale).toVar(), lattice);
  const bitsFrom = (shift: number, mask: number): Value =>
    vec4(hashes.shiftRight(uvec4(shift)).bitAnd(uvec4(mask))).toVar();
  // Where B turns into −B strokes stay: the map is symmetric about its centre, and is shifted by half tiles only.
  const shiftU = isUpToSign ? bitsFrom(0, 1).mul(0.5) : bitsFrom(0, 0xffff).mul(1 / 65536);
  const shiftV = isUpToSign ? bitsFrom(16, 1).mul(0.5) : bitsFrom(16, 0xffff).mul(1 / 65536);
  const along = vec4(...offsets.map((offset) => dot(h.uAxis, offset))).mul(anchorSpacing);
  const across = vec4(...offsets.map((offset) => dot(h.vAxis, offset))).mul(anchorSpacing);
  // One bit of each word mirrors its strokes.
  const mirrored = float(1).sub(bitsFrom(15, 1).mul(2));
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
  // Octaves by which the map at `tilesPerUnit` is magnified: above 0 near, below 0 far away.
  const magnification = levelByDepth(thresholdMapSize, vUnitsPerPixel).negate().toVar();
  const foreshortened = foreshortenedOctaves(h.lean);
  const beyond = max(foreshortened.sub(FREE_CROWDING), 0);
  const wanted = isSizedOnScreen ? sizedOnScreen.mul(magnification).div(LATTICE_OCTAVES).toVar() : float(0);
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
    const fade = smoothstep(1 - LATTICE_FADE, 1, float(1).sub(lattice.sub(wanted))).toVar();
    If(isInked, () => {
      add(0, float(1).sub(fade));
      If(fade.greaterThan(0), () => add(1, fade));
    });
    // The fields are independent: their variances add.
    g.mulAssign(inverseSqrt(float(1).sub(fade.mul(2).mul(float(1).sub(fade)))));
  }
  const crowding = faceOn.add(foreshortened).sub(levelFor(octaves)).toVar();
  return { field: { g, mixing }, crowding };
}

/** Not to be called in branches: the edges of strokes need screen-space derivatives. */
export function hatchLayer(h: HatchingParameters, tone: Value, defines: StrokeDefines): Value {
  const isInked = tone.add(fwidth(tone)).greaterThan(0).toVar();
  const { field, crowding } = anchoredField(h, isInked, defines);
  return defines.medium === 'dry' ? dryInkAt(field, tone, crowding, defines.pixel) : inkAt(field, tone, crowding);
}
