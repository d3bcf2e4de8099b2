/** Lines where parts meet that move, over the whole screen. */
import type { Node, NodeBuilder } from 'three/webgpu';
import { OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { lightsOf, meanLight } from '../base/lights.js';
import { isOrthographic, lineCoverage, pixelFromBelow } from '../base/maths.js';
import { blankPoses, hatchingTexture, hatchingUniform } from '../base/uniforms.js';
import { threeNodes, tsl, type Value } from '../base/values.js';
import { outlineFadingAt } from '../chunks/fading.js';
import { dryInk, inked, type OutlineDefines, opacity, spinePosition } from './fragments.js';
import { isDrawnBefore, outlineWidth } from './hierarchy.js';
import type { OutlineNodes } from './outlineNodes.js';
import { NUMBERS, nearnessOfPart, numberOfPart, placePart } from './partMap.js';
import { depthAt, hasSceneDepth, NOWHERE, projection, viewport } from './sceneDepth.js';
import { shadeWeights } from './shade.js';

const {
  abs,
  bool,
  ceil,
  cross,
  dFdx,
  dFdy,
  Discard,
  dot,
  float,
  floor,
  Fn,
  If,
  int,
  ivec2,
  length,
  Loop,
  max,
  min,
  mix,
} = tsl;
const { modelViewMatrix, normalize, select, smoothstep, varyingProperty, vec2, vec3, vec4, vertexIndex } = tsl;
const { LIT, SHADED } = OUTLINE_CONSTANTS;

/** Counterpart of shaders/meetings/meeting.vert. */

/** Towards the light, unit, view space; 0 if no light has a direction. */
const vMeetingLight = /* @__PURE__ */ varyingProperty('vec3', 'vMeetingLight');

function writeLight(builder: NodeBuilder): void {
  const light = meanLight(modelViewMatrix.mul(vec4(0, 0, 0, 1)).xyz, lightsOf(builder)).toVar();
  vMeetingLight.assign(light.div(max(length(light), 1e-20)));
}

const vertex = /* @__PURE__ */ Fn((builder) => {
  writeLight(builder);
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

/** The part that is drawn. */
function ownPart(): Part {
  const nearness = nearnessOfPart().toVar();
  const slope = vec2(dFdx(nearness), dFdy(nearness)).toVar();
  return { number: numberOfPart().toVar(), look: float(0), nearness, slope };
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

/** The nearest line: how far it is away, pixels, and a normal there, of any length. */
interface Nearest {
  away: Value;
  normal: Value;
}

/** A part as it is seen, with its normal. */
type Faced = Part & { normal: Value };

const crosses = (own: Faced, normal: Value, sight: Value): Value =>
  length(cross(own.normal, normal))
    .greaterThanEqual(LEAST_CROSSING)
    .and(dot(normal, sight).greaterThanEqual(TURNS_AWAY));

/** Finds where the own part, which is seen through, cuts the part in its pixel. */
function findThrough({ away, normal }: Nearest, own: Faced, other: Part, pixel: Value, sight: Value): void {
  const otherNormal = normalOf(other, pixel);
  const isOther = other.number.greaterThan(0).and(other.number.notEqual(own.number));
  If(isOther.and(crosses(own, otherNormal, sight)), () => {
    away.assign(abs(own.nearness.sub(other.nearness)).div(max(length(own.slope.sub(other.slope)), 1e-30)));
    normal.assign(own.normal.add(otherNormal));
  });
}

/** Finds where the own part meets those in pixels around. */
function findAround(
  { away, normal }: Nearest,
  own: Faced,
  texel: Value,
  reach: Value,
  pixel: Value,
  sight: Value,
): void {
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
            If(crosses(own, otherNormal, sight), () => {
              away.assign(distanceTo);
              normal.assign(own.normal.add(otherNormal));
            });
          });
        });
      });
    });
  });
}

/** The ink, and the share of a pixel that it covers. */
const fragments = ({ PAPER_GRAIN }: OutlineDefines, isClear: boolean): Value =>
  Fn((builder) => {
    const pixel = pixelFromBelow().toVar();
    const texel = ivec2(pixel.sub(viewport.xy)).toVar();
    const seen = partAt(texel);
    const part = isClear ? ownPart() : seen;
    const own = { ...part, normal: normalOf(part, pixel) };
    const place = placeOf(own, pixel);
    const sight = select(isOrthographic(), vec3(0, 0, 1), normalize(place.negate())).toVar();
    if (!isClear) Discard(own.look.notEqual(partLook).or(dot(own.normal, sight).lessThan(TURNS_AWAY)));
    spinePosition.assign(place);
    const width = outlineWidth.mul(0.5).mul(intersections).mul(outlineFadingAt(place, pixel)).toVar();
    const most = max(width.mul(max(shadeWeights.x, shadeWeights.y)), 0.5);
    const reach = min(int(ceil(most.add(0.5))), int(MOST_REACH)).toVar();

    const nearest = { away: float(NOWHERE).toVar(), normal: own.normal.toVar() };
    const { away, normal } = nearest;
    if (isClear) findThrough(nearest, own, seen, pixel, sight);
    else findAround(nearest, own, texel, reach, pixel, sight);

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

const known = /* @__PURE__ */ new Map<string, OutlineNodes>();

/** What draws lines: a triangle over the screen, or the surface of a part that is seen through, whose instances have matrices. */
type Drawn = 'screen' | 'clear' | 'clearInstances';

function nodesOf(drawn: Drawn, defines: OutlineDefines): OutlineNodes {
  const key = `meeting ${drawn} ${defines.PAPER_GRAIN}`;
  let nodes = known.get(key);
  if (!nodes) {
    const isClear = drawn !== 'screen';
    nodes = {
      key,
      vertex: isClear ? null : vertex,
      color: fragments(defines, isClear) as unknown as Node<'vec4'>,
      outgoing: threeNodes.diffuseColor.rgb,
      viewZ: spinePosition.z as unknown as Node<'float'>,
      logarithmicDepth: null,
      place(builder) {
        placePart(builder, drawn === 'clearInstances');
        writeLight(builder);
      },
    };
    known.set(key, nodes);
  }
  return nodes;
}

/** The nodes of lines where parts meet. */
export const meetingNodes = (defines: OutlineDefines): OutlineNodes => nodesOf('screen', defines);

/** The nodes of lines on a part that is seen through. */
export const clearNodes = (defines: OutlineDefines): OutlineNodes => nodesOf('clear', defines);

/** The nodes of lines on instances that are seen through. */
export const clearInstanceNodes = (defines: OutlineDefines): OutlineNodes => nodesOf('clearInstances', defines);
