/** Dots, which are loaded when a material first draws with them. */
import type { NodeBuilder } from 'three/webgpu';
import { STIPPLE_CONSTANTS } from '../../../look/constants/patternConstants.js';
import { STIPPLE_MAP_SIZE } from '../../../material/tam/patternSizes.js';
import { isOrthographic, largestComponents } from '../base/maths.js';
import { blankDots, hatchingTexture, hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { readViewToAnchor } from '../chunks/anchor.js';
import { anyTangent } from '../chunks/lightOrientation.js';
import {
  centreOfScreen,
  type ScreenMap,
  screenGradient,
  screenMapOf,
  viewUnitsPerPixel,
} from '../chunks/screenGradient.js';
import { tilesPerObjectUnit } from '../chunks/thresholdMap.js';
import type { HatchingParameters } from './read.js';

const { abs, clamp, cross, dot, exp2, float, floor, fract, If, int, inverseSqrt, ivec2, length, log2, Loop, max } = tsl;
const { min, mix, normalize, positionView, pow, select, sqrt, step, vec2, vec3 } = tsl;
const { CLOSING, CROWDING, DOT_GROWTH, DOT_SHARE, DOTS_PER_TILE, FILLING, FROM_BEHIND } = STIPPLE_CONSTANTS;
const { LEAST_BLANK, LEAST_DENSE_SHARE, LEAST_PULL, LEAST_ROUND, LEAST_SHARE, OVERLAP } = STIPPLE_CONSTANTS;
const { OVERLAP_WITHIN, PLANE_FADE, SET_SHIFT } = STIPPLE_CONSTANTS;

/** Counterpart of shaders/techniques/strokes/dots.glsl: the dots of one plane, a disc on the screen for each point of the set. */

const stippleMap = /* @__PURE__ */ hatchingTexture('stippleMap', blankDots);
const edgePixels = /* @__PURE__ */ hatchingUniform('edgePixels', 'float');

/** The greatest distance, in cells, from which a dot reaches a place, and the most cells of a row within that distance. */
const MOST_REACH = 1.5;
const MOST_CELLS = 4;
/** A disc of radius r whose edge fades over a width of 1 covers π (r² + 1/12). */
const EDGE_COVER = 1 / 12;
/** A smaller disc would be all edge: it is drawn with this squared radius, and paler. */
const LEAST_SQUARED_RADIUS = 0.25;
const FADING = 3;

/** The screen-space derivatives of the coordinates of a plane. */
export interface PlaneOnScreen {
  /** Per pixel. */
  gradientU: Value;
  gradientV: Value;
  /** Object units² per pixel; its sign is the orientation. */
  area: Value;
}

const planeOnScreen = (gradientU: Value, gradientV: Value): PlaneOnScreen => ({
  gradientU,
  gradientV,
  area: gradientU.x.mul(gradientV.y).sub(gradientU.y.mul(gradientV.x)).toVar(),
});

/** The mean area, as a share of the full one, of the dots that appear during an octave. */
function grownShare(octave: Value): Value {
  const t = max(vec2(octave, octave.add(DOT_GROWTH - 1)), 0).toVar();
  const growing = t.mul(t).mul(0.5 / DOT_GROWTH);
  const covered = mix(growing, t.sub(0.5 * DOT_GROWTH), step(DOT_GROWTH, t)).toVar();
  return covered.x.sub(covered.y).div(1 - DOT_GROWTH);
}

/** The area of a dot during an octave, as a share of its full area. @param born 0 for dots of the octave before */
const grownBy = (octave: Value, born: Value): Value =>
  clamp(octave.sub(born.mul(1 - DOT_GROWTH)).div(DOT_GROWTH), step(born, 0), 1);

/** The total area of discs that together cover a share of the plane, as a share of the plane. From 0.5 on they overlap. */
function discArea(covered: Value, octave: Value): Value {
  const beyond = max(covered.sub(0.5), 0).toVar();
  const rest = octave.oneMinus().toVar();
  const overlap = octave.mul(OVERLAP_WITHIN).mul(rest).mul(rest).add(OVERLAP);
  return covered.add(
    overlap
      .mul(beyond)
      .mul(beyond)
      .mul(inverseSqrt(max(covered.oneMinus(), LEAST_BLANK))),
  );
}

/** The radius of a disc whose soft edge does not enlarge it, in widths of the edge. */
const softRadius = (squared: Value): Value => sqrt(max(squared.sub(EDGE_COVER), LEAST_SQUARED_RADIUS));

/** The share of a pixel that a dot covers. @param away distance to its centre, in widths of the edge; the root of `squared` */
const dotCover = (away: Value, squared: Value): Value =>
  clamp(softRadius(squared).sub(away).add(0.5), 0, 1).mul(min(squared.mul(FADING), 1));

/**
 * The share of the fragment that the dots of a plane cover.
 *
 * @param octave of the cells per object unit
 * @param share the share that all of its dots cover
 */
function dotsAt(at: Value, { gradientU, gradientV, area }: PlaneOnScreen, octave: Value, share: Value): Value {
  const cells = exp2(floor(octave).add(1)).toVar();
  const into = fract(octave).toVar();
  // A quarter of the cells had their dots before this octave.
  const dotsPerCell = grownShare(into).mul(0.75).add(0.25);
  // In widths of the edge: the squared radius of a full-grown dot, and the Jacobian from cells to the screen.
  const edge = max(edgePixels, 1e-2).toVar();
  const perCell = max(abs(area), 1e-20).mul(cells).mul(cells).mul(dotsPerCell).mul(edge).mul(edge);
  const squared = discArea(share, into)
    .mul(1 / Math.PI)
    .div(perCell)
    .toVar();
  const scale = area.mul(cells).mul(edge).toVar();
  const columnU = vec2(gradientV.y, gradientV.x.negate()).div(scale).toVar();
  const columnV = vec2(gradientU.y.negate(), gradientU.x).div(scale).toVar();
  const place = at.mul(cells).toVar();
  // Rows of cells whose dots may reach this place.
  const largest = softRadius(squared).add(0.5);
  const reach = min(largest.mul(edge).mul(cells).mul(length(gradientV)), MOST_REACH).toVar();
  const left = floor(place.x.sub(MOST_REACH)).toVar();
  const lowest = floor(place.y.sub(reach)).toVar();
  const highest = floor(place.y.add(reach)).toVar();
  const covered = float(0).toVar();
  const range = { start: int(0), end: int(MOST_CELLS), type: 'int', condition: '<' };
  // A bounded loop, so that broken meshes cannot stall the GPU.
  Loop(range, ({ i: row }) => {
    const y = lowest.add(float(row)).toVar();
    If(y.lessThanEqual(highest), () => {
      Loop({ ...range, name: 'column' }, ({ column }) => {
        const cell = vec2(left.add(float(column)), y).toVar();
        const texel = stippleMap.load(ivec2(cell).bitAnd(ivec2(STIPPLE_MAP_SIZE - 1))).toVar();
        const way = cell.add(texel.xy).sub(place).toVar();
        const away = columnU.mul(way.x).add(columnV.mul(way.y));
        // Two dots that meet in a pixel each cover a part of it.
        covered.addAssign(dotCover(length(away), squared.mul(grownBy(into, texel.z)).toVar()));
      });
    });
  });
  return min(covered, 1);
}

/**
 * Counterpart of shaders/techniques/strokes/stipple.glsl: dots that are fixed on the surface and round on the screen. A set of points in a
 * plane is projected onto the surface along the normal of the plane. There are thirteen planes, perpendicular to the axes of a cube through
 * its faces, edges and corners.
 */

const screenSpaceShare = /* @__PURE__ */ hatchingUniform('screenSpaceShare', 'float');
const dotPixels = /* @__PURE__ */ hatchingUniform('dotPixels', 'float');

/** Components of unit vectors along the diagonals of a square and of a cube: 1/√2 and 1/√3. */
const SQUARE_DIAGONAL = Math.SQRT1_2;
const CUBE_DIAGONAL = 0.57735027;

const largestOf = ({ x, y, z }: Value): Value => max(x, max(y, z));
const signOf = (x: Value): Value => select(x.lessThan(0), -1, 1);

/** The three planes whose axes are nearest to a direction. */
interface StipplePlanes {
  /** A mask of the nearest axis. */
  nearest: Value;
  /** A mask of the two nearest. */
  nearestTwo: Value;
  /** Signs of the direction. */
  side: Value;
  /** The shares of the dots that lie in each plane. */
  shares: Value;
}

function planeShares(cosines: Value): Value {
  const shares = clamp(cosines.sub(largestOf(cosines)).div(PLANE_FADE).add(1), 0, 1).toVar();
  shares.mulAssign(shares);
  return shares.div(shares.x.add(shares.y).add(shares.z)).toVar();
}

function planesNear(direction: Value): StipplePlanes {
  const towards = abs(direction).toVar();
  const { largest: nearest, twoLargest: nearestTwo } = largestComponents(towards);
  const sums = vec3(dot(towards, nearest), dot(towards, nearestTwo), towards.x.add(towards.y).add(towards.z));
  const shares = planeShares(sums.mul(vec3(1, SQUARE_DIAGONAL, CUBE_DIAGONAL)).toVar());
  const side = vec3(signOf(direction.x), signOf(direction.y), signOf(direction.z)).toVar();
  return { nearest, nearestTwo, side, shares };
}

/** The unit axis of the plane with the largest remaining share, which is then removed. */
function takePlane({ nearest, nearestTwo, side, shares }: StipplePlanes, share: Value): Value {
  const { x, y, z } = shares.toVar();
  const others = select(share.equal(y), nearestTwo.mul(SQUARE_DIAGONAL), vec3(CUBE_DIAGONAL));
  const axis = select(share.equal(x), nearest, others).mul(side).toVar();
  const left = (own: Value): Value => select(own.equal(share), 0, own);
  shares.assign(vec3(left(x), left(y), left(z)));
  return axis;
}

/**
 * The direction that chooses the planes: half way from the normal to the viewer, nearer to the viewer at grazing angles, where dots must
 * face the screen.
 */
const directionOfNeedles = (front: Value, toViewer: Value): Value =>
  normalize(front.mul(max(dot(front, toViewer), LEAST_PULL)).add(toViewer)).toVar();

/** The screen map of the tangent plane, with the angle limited to where dots stay round. */
function roundScreenMap(n: Value, viewToPlace: Value): ScreenMap {
  const normal = n.mul(viewToPlace).toVar();
  const toViewer = vec3(centreOfScreen(), 1).toVar();
  const facing = dot(normal, toViewer).toVar();
  const least = length(normal).mul(LEAST_ROUND).toVar();
  normal.addAssign(toViewer.mul(max(least.sub(facing), 0).div(dot(toViewer, toViewer))));
  normal.mulAssign(viewUnitsPerPixel().div(max(facing, least)));
  return screenMapOf(normal, toViewer.xy.toVar(), viewToPlace);
}

/** The share that dots cover at a tone: the tone itself in the lights, more in the darks, which end solid. */
function coverOf(tone: Value): Value {
  const way = clamp(tone.sub(CLOSING[0]).div(CLOSING[1] - CLOSING[0]), 0, 1).toVar();
  return min(tone.add(way.mul(way).mul(1 - CLOSING[1])), 1).toVar();
}

/** The logarithm to base 2 of cells per object unit at which dots cover half. */
function octaveOf({ area }: PlaneOnScreen): Value {
  const onObject = log2(tilesPerObjectUnit.mul(DOTS_PER_TILE));
  const onScreen = log2(max(abs(area), 1e-30))
    .mul(-0.5)
    .sub(log2(dotPixels.div(DOT_SHARE)))
    .toVar();
  return mix(min(onObject, onScreen), onScreen, screenSpaceShare);
}

/** The share that the dots of the plane across an axis cover. */
function dotsAcross(point: Value, axis: Value, cover: Value, onScreen: ScreenMap): Value {
  const u = normalize(anyTangent(axis)).toVar();
  const v = cross(axis, u).toVar();
  const plane = planeOnScreen(screenGradient(u, onScreen).toVar(), screenGradient(v, onScreen).toVar());
  const dense = log2(max(cover, LEAST_DENSE_SHARE).oneMinus()).negate();
  const crowding = log2(dense).mul(0.5 * CROWDING);
  const [x, y, z] = SET_SHIFT;
  const shift = vec2(dot(axis, vec3(x, y, z)), dot(axis, vec3(y, z, x))).div(tilesPerObjectUnit);
  const place = vec2(dot(point, u), dot(point, v)).add(shift).toVar();
  return dotsAt(place, plane, octaveOf(plane).add(crowding).toVar(), cover);
}

export function hatchLayer(h: HatchingParameters, tone: Value, builder: NodeBuilder): Value {
  const cover = coverOf(tone);
  const printed = cover.toVar();
  If(cover.greaterThan(0).and(cover.lessThan(1)), () => {
    const viewToAnchor = readViewToAnchor(builder);
    const blank = cover.oneMinus().toVar();
    const towards = select(isOrthographic(), vec3(0, 0, 1), positionView.negate());
    const toViewer = normalize(viewToAnchor.mul(towards)).toVar();
    // The normal of a back-facing sheet points away.
    const isBehind = dot(h.normal, toViewer).lessThan(FROM_BEHIND);
    const front = select(isBehind, h.normal.negate(), h.normal).toVar();
    const planes = planesNear(directionOfNeedles(front, toViewer));
    const onScreen = roundScreenMap(front, viewToAnchor);
    const left = float(1).toVar();
    Loop({ start: int(0), end: int(3), type: 'int', condition: '<', name: 'plane' }, () => {
      const share = largestOf(planes.shares).toVar();
      If(share.greaterThanEqual(LEAST_SHARE), () => {
        const axis = takePlane(planes, share);
        // Planes are printed over one another.
        const covered = pow(blank, share).oneMinus().toVar();
        left.mulAssign(dotsAcross(h.point, axis, covered, onScreen).oneMinus());
      });
    });
    printed.assign(left.mul(min(blank.div(1 - FILLING), 1)).oneMinus());
  });
  return printed;
}
