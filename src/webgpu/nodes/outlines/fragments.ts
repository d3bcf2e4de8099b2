/**
 * Counterpart of shaders/outlines/outlines.frag. A piece of outline is a capsule on the screen, so that pieces join without mitres; its
 * edge fades over one pixel.
 */

import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { outlineFadingAt } from '../chunks/fading.js';
import { lineCoverage } from '../chunks/lineCoverage.js';
import { dryInk } from './dryOutline.js';
import { hiddenCoverage } from './hidden.js';
import {
  accents,
  alongLine,
  halfWidthAs,
  isCutAway,
  isSeen,
  lineWeightAt,
  outlineWidth,
  type Spine,
} from './hierarchy.js';
import type { OutlineDefines } from './OutlineDefines.js';
import { hasSceneDepth } from './sceneDepth.js';
import {
  vAnchorEnd,
  vAnchorStart,
  vContour,
  vEnd,
  vEnds,
  vHalfWidths,
  vLineWeights,
  vOrigin,
  vOvershoots,
  vStart,
  vTolerance,
} from './varyings.js';
import { pressureWave, wobbleAt } from './wobble.js';

const { Discard, Fn, If, bool, clamp, distance, dot, float, length, max, min, mix, screenCoordinate, screenSize } = tsl;
const { select, vec2, vec4 } = tsl;

const ink = /* @__PURE__ */ hatchingUniform('ink', 'color');
const opacity = /* @__PURE__ */ hatchingUniform('opacity', 'float');

/** The point on the spine that a fragment belongs to, view space. Fog depends on it. */
export const spinePosition: Value = /* @__PURE__ */ tsl.property('vec3', 'outlineSpinePosition');

/** The point on the spine nearest to a fragment. */
interface OnSpine {
  spine: Spine;
  /** Distance along the outline from its start, pixels. */
  place: Value;
  /** The pixel, with the wobble of the outline subtracted. */
  pixel: Value;
  /** The share of the way from start to end on the screen. */
  t: Value;
}

/** The pixel of a fragment, counted from the lower left. */
const drawnPixel = (): Value => vec2(screenCoordinate.x, screenSize.y.sub(screenCoordinate.y)).toVar();

export function onSpine({ WOBBLE }: OutlineDefines): OnSpine {
  const pixel = drawnPixel();
  const ends = vEnds.zw.sub(vEnds.xy).toVar();
  const size = length(ends).toVar();
  const along = select(size.greaterThan(1e-4), ends.div(max(size, 1e-4)), vec2(1, 0)).toVar();
  const spine = { start: vEnds.xy, viewStart: vStart.xyz, viewEnd: vEnd.xyz, along, size, tolerance: vTolerance };
  const place = dot(pixel.sub(spine.start), along).toVar();
  if (WOBBLE) {
    const share = alongLine(clamp(place.div(max(size, 1e-4)), 0, 1).toVar(), spine);
    pixel.assign(pixel.sub(wobbleAt(mix(vAnchorStart, vAnchorEnd, share))));
    place.assign(dot(pixel.sub(spine.start), along));
  }
  const t = clamp(place, 0, size).div(max(size, 1e-4)).toVar();
  return { spine, place, pixel, t };
}

/** The ink, and the share of a pixel that it covers. */
export const fragments = (defines: OutlineDefines): Value =>
  Fn((builder) => {
    const { spine, place, pixel, t } = onSpine(defines);
    const { size } = spine;
    const onOutline = clamp(place, vOvershoots.x.negate(), size.add(vOvershoots.y)).toVar();
    const away = distance(pixel, spine.start.add(onOutline.mul(spine.along))).toVar();
    spinePosition.assign(mix(vStart.xyz, vEnd.xyz, alongLine(t, spine)));
    // Per fragment, not at the ends: an edge may run across the whole sheet.
    const usual = mix(vHalfWidths.xz, vHalfWidths.yw, t);
    const halves = outlineFadingAt(spinePosition, drawnPixel()).mul(usual).toVar();
    const most = max(halves.x, halves.y).toVar();
    const coverage = float(0).toVar();
    If(away.lessThanEqual(max(most.mul(accents.add(1)), 0.5).add(0.5)), () => {
      const halfWidth = halves.x.toVar();
      const isDrawn = bool(true).toVar();
      if (hasSceneDepth(builder)) {
        const seen = spine.start.add(clamp(place, 0, size).mul(spine.along)).toVar();
        const isBefore = isSeen(spine, seen, builder);
        isDrawn.assign((defines.HIDDEN ? isBefore.not() : isBefore).and(isCutAway(spine, seen, builder).not()));
        If(isDrawn, () => {
          const lineWeight = mix(vLineWeights.xy, vLineWeights.zw, t).toVar();
          If(vLineWeights.x.lessThan(0), () => {
            lineWeight.assign(lineWeightAt(spine, seen, most, builder));
          });
          halfWidth.assign(halfWidthAs(lineWeight, halves, vContour));
        });
      }
      // Round ends fill the joints. Their edges lie inside, or two fading edges would add up beside each joint.
      const isAtEnd = place.notEqual(onOutline).toVar();
      If(isDrawn, () => {
        coverage.assign(lineCoverage(away, halfWidth, select(isAtEnd, float(0), float(0.5))));
        if (defines.HIDDEN) {
          coverage.mulAssign(hiddenCoverage(place, size, spine.along, pixel.sub(vOrigin), outlineWidth));
        }
        if (defines.TOOTH) {
          const pressed = defines.WOBBLE ? pressureWave(mix(vAnchorStart, vAnchorEnd, alongLine(t, spine))) : float(1);
          // Overlapping ends are narrower, or their soft sides would add up at each joint.
          const across = away.div(max(halfWidth, 0.5)).mul(select(isAtEnd, float(1.6), float(1)));
          coverage.mulAssign(dryInk(min(across, 1).toVar(), pressed, drawnPixel()));
        }
      });
    });
    Discard(coverage.mul(opacity).lessThan(0.002));
    return vec4(ink, coverage);
  })();
