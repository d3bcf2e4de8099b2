/** Lines where parts meet that move, over the whole screen. */
import type { Node } from 'three/webgpu';
import { OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { lightsOf, meanLight } from '../base/lights.js';
import { isOrthographic, lineCoverage, pixelFromBelow } from '../base/maths.js';
import { blankPoses, hatchingTexture, hatchingUniform } from '../base/uniforms.js';
import { threeNodes, tsl, type Value } from '../base/values.js';
import { outlineFadingAt } from '../chunks/fading.js';
import { dryInk, inked, type OutlineDefines, opacity, spinePosition } from './fragments.js';
import { isDrawnBefore, outlineWidth } from './hierarchy.js';
import type { OutlineNodes } from './outlineNodes.js';
import { NUMBERS } from './partMap.js';
import { depthAt, hasSceneDepth, NOWHERE, projection, viewport } from './sceneDepth.js';
import { shadeWeights } from './shade.js';

const { abs, bool, ceil, cross, Discard, dot, float, floor, Fn, If, int, ivec2, length, Loop, max, min, mix } = tsl;
const { modelViewMatrix, normalize, select, smoothstep, varyingProperty, vec2, vec3, vec4, vertexIndex } = tsl;
const { LIT, SHADED } = OUTLINE_CONSTANTS;

/** Counterpart of shaders/meetings/meeting.vert. */

/** Towards the light, unit, view space; 0 if no light has a direction. */
const vMeetingLight = /* @__PURE__ */ varyingProperty('vec3', 'vMeetingLight');

const vertex = /* @__PURE__ */ Fn((builder) => {
  const light = meanLight(modelViewMatrix.mul(vec4(0, 0, 0, 1)).xyz, lightsOf(builder)).toVar();
  vMeetingLight.assign(light.div(max(length(light), 1e-20)));
  const index = int(vertexIndex).toVar();
  return vec4(select(index.equal(int(1)), float(3), float(-1)), select(index.equal(int(2)), float(3), float(-1)), 0, 1);
})() as unknown as Node<'vec4'>;

/**
 * Counterpart of shaders/meetings/meeting.frag. Two parts that are seen in neighbouring pixels meet between them where the plane of each,
 * continued to the pixel of the other, lies behind that.
 */

/** Most pixels from a line at which it is drawn. */
const MOST_REACH = 4;
/** Sine of the angle between two faces, some 15°, below which they have no line: panels that nearly touch. */
const LEAST_CROSSING = 0.26;
/** Cosine between a normal and the line of sight, some 78°, below which a surface counts as one that turns away, and may not reach the other. */
const TURNS_AWAY = 0.2;
/** Pixels by which a surface may be steeper than its plane says before something else hides it. */
const STEEPER = 2;
/** Share of a distance that is lost in rounding. */
const LOST_DEPTH = 1e-4;

const partMap = /* @__PURE__ */ hatchingTexture('partMap', /* @__PURE__ */ blankPoses());
/** The number of the material of these outlines. */
const partLook = /* @__PURE__ */ hatchingUniform('partLook', 'float');
/** Weight. */
const intersections = /* @__PURE__ */ hatchingUniform('intersections', 'float');

/** A part in a pixel. */
interface Part {
  /** From 1; 0 where there is none. */
  number: Value;
  /** The number of the material of its outlines. */
  look: Value;
  /** The inverse distance; with an orthographic camera the distance, negated. */
  nearness: Value;
  /** The change of the nearness per pixel, to the right and upwards. */
  slope: Value;
}

function partIn(word: Value): Part {
  const look = floor(word.x.div(NUMBERS)).toVar();
  return { number: word.x.sub(look.mul(NUMBERS)).toVar(), look, nearness: word.y, slope: word.zw };
}

/** The part in a pixel of the view, counted from the lower left: three.js flips the rows of render targets. */
const partAt = (texel: Value): Part =>
  partIn(partMap.load(ivec2(texel.x, int(viewport.w).sub(1).sub(texel.y))).toVar());

const perUnit = (): Value => vec2(projection(0, 0), projection(1, 1));

const onSheetPlane = (pixel: Value): Value => pixel.sub(viewport.xy).mul(2).div(viewport.zw).sub(1);

/** Direction of the line of sight through a pixel, at a depth of 1. */
const rayAt = (pixel: Value): Value =>
  onSheetPlane(pixel)
    .add(vec2(projection(2, 0), projection(2, 1)))
    .div(perUnit());

/** Unit, towards the eye, view space. */
function normalOf({ slope, nearness }: Part, pixel: Value): Value {
  const inView = slope.mul(0.5).mul(viewport.zw).mul(perUnit()).toVar();
  const facing = vec3(inView.negate(), 1);
  const seen = vec3(inView, dot(inView, rayAt(pixel)).sub(nearness)).negate();
  return normalize(select(isOrthographic(), facing, seen)).toVar();
}

function placeOf({ nearness }: Part, pixel: Value): Value {
  const inParallel = onSheetPlane(pixel)
    .sub(vec2(projection(3, 0), projection(3, 1)))
    .div(perUnit());
  return select(isOrthographic(), vec3(inParallel, nearness), vec3(rayAt(pixel), -1).div(nearness)).toVar();
}

/** The ink, and the share of a pixel that it covers. */
const fragments = ({ PAPER_GRAIN }: OutlineDefines): Value =>
  Fn((builder) => {
    const pixel = pixelFromBelow().toVar();
    const texel = ivec2(pixel.sub(viewport.xy)).toVar();
    const own = partAt(texel);
    const ownNormal = normalOf(own, pixel);
    const place = placeOf(own, pixel);
    const sight = select(isOrthographic(), vec3(0, 0, 1), normalize(place.negate())).toVar();
    const turnsAway = dot(ownNormal, sight).lessThan(TURNS_AWAY);
    Discard(own.look.notEqual(partLook).or(turnsAway));
    spinePosition.assign(place);
    const width = outlineWidth.mul(0.5).mul(intersections).mul(outlineFadingAt(place, pixel)).toVar();
    const most = max(width.mul(max(shadeWeights.x, shadeWeights.y)), 0.5);
    const reach = min(int(ceil(most.add(0.5))), int(MOST_REACH)).toVar();

    const away = float(NOWHERE).toVar();
    const normal = ownNormal.toVar();
    const last = ivec2(viewport.zw).sub(1).toVar();
    const range = { start: reach.negate(), end: reach, type: 'int', condition: '<=' };
    Loop({ ...range, name: 'row' }, ({ row }) => {
      Loop({ ...range, name: 'column' }, ({ column }) => {
        const there = texel.add(ivec2(column, row)).toVar();
        const isInside = (at: Value, end: Value): Value => at.greaterThanEqual(int(0)).and(at.lessThanEqual(end));
        If(isInside(there.x, last.x).and(isInside(there.y, last.y)), () => {
          const other = partAt(there);
          If(other.number.greaterThan(0).and(other.number.notEqual(own.number)), () => {
            const way = vec2(column, row).toVar();
            const gap = own.nearness.sub(other.nearness).toVar();
            const before = gap.add(dot(other.slope, way)).toVar();
            const beyond = gap.add(dot(own.slope, way));
            const distanceTo = before.div(max(length(own.slope.sub(other.slope)), 1e-30)).toVar();
            If(before.greaterThanEqual(0).and(beyond.lessThanEqual(0)).and(distanceTo.lessThan(away)), () => {
              const otherNormal = normalOf(other, pixel.add(way));
              const isSteep = length(cross(ownNormal, otherNormal)).greaterThanEqual(LEAST_CROSSING);
              If(isSteep.and(dot(otherNormal, sight).greaterThanEqual(TURNS_AWAY)), () => {
                away.assign(distanceTo);
                normal.assign(ownNormal.add(otherNormal));
              });
            });
          });
        });
      });
    });

    const isSeen = bool(true).toVar();
    if (hasSceneDepth(builder)) {
      const depth = place.z.negate().toVar();
      const steep = length(own.slope).mul(select(isOrthographic(), float(1), depth.mul(depth)));
      const least = depth.sub(steep.mul(STEEPER)).sub(abs(depth).mul(LOST_DEPTH));
      isSeen.assign(isDrawnBefore.greaterThan(0.5).or(depthAt(pixel, builder).greaterThanEqual(least)));
    }
    const share = smoothstep(LIT, SHADED, float(0.5).sub(dot(normalize(normal), vMeetingLight).mul(0.5)));
    const halfWidth = width.mul(mix(shadeWeights.x, shadeWeights.y, share)).toVar();
    const coverage = select(isSeen.and(away.lessThan(NOWHERE)), lineCoverage(away, halfWidth, 0.5), float(0)).toVar();
    if (PAPER_GRAIN) {
      coverage.mulAssign(dryInk(min(away.div(max(halfWidth, 0.5)), 1).toVar(), float(1), pixel));
    }
    return inked(coverage.mul(opacity).toVar());
  })();

const known = /* @__PURE__ */ new Map<boolean, OutlineNodes>();

/** The nodes of lines where parts meet. */
export function meetingNodes(defines: OutlineDefines): OutlineNodes {
  let nodes = known.get(defines.PAPER_GRAIN);
  if (!nodes) {
    nodes = {
      key: `meeting ${defines.PAPER_GRAIN}`,
      vertex,
      color: fragments(defines) as unknown as Node<'vec4'>,
      outgoing: threeNodes.diffuseColor.rgb,
      viewZ: spinePosition.z as unknown as Node<'float'>,
      logarithmicDepth: null,
    };
    known.set(defines.PAPER_GRAIN, nodes);
  }
  return nodes;
}
