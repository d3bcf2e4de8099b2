/**
 * Counterpart of shaders/techniques/anchored/stipple.glsl: dots that are fixed on the surface and round on the screen. A set of points in a
 * plane is projected onto the surface along the normal of the plane. There are thirteen planes, perpendicular to the axes of a cube through
 * its faces, edges and corners.
 */
import type { NodeBuilder } from 'three/webgpu';
import { STIPPLE_CONSTANTS } from '../../../look/constants/stippleConstants.js';
import { isOrthographic } from '../base/isOrthographic.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { largestComponents } from '../chunks/largestComponents.js';
import { tilesPerUnit } from '../chunks/levelByDepth.js';
import { anyTangent } from '../chunks/lightOrientation.js';
import {
  centreOfScreen,
  type ScreenMap,
  screenGradient,
  screenMapOf,
  viewUnitsPerPixel,
} from '../perFragment/screenGradient.js';
import { readViewToAnchor } from '../perFragment/viewToAnchor.js';
import { dotsAt, type PlaneOnScreen, planeOnScreen } from './dots.js';
import type { HatchingParameters } from './read.js';

const { abs, clamp, cross, dot, float, If, int, length, log2, Loop, max, min, mix, normalize, positionView } = tsl;
const { pow, select, vec2, vec3 } = tsl;
const { CLOSING, CROWDING, DOT_SHARE, DOTS_PER_TILE, FILLING, FROM_BEHIND, LEAST_DENSE_SHARE } = STIPPLE_CONSTANTS;
const { LEAST_PULL, LEAST_ROUND, LEAST_SHARE, PLANE_FADE, SET_SHIFT } = STIPPLE_CONSTANTS;

/** 0: dots spaced on the object, 1: on the screen. */
const sizedOnScreen = /* @__PURE__ */ hatchingUniform('sizedOnScreen', 'float');
/** Diameter of a dot at half tone. */
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
  const onObject = log2(tilesPerUnit.mul(DOTS_PER_TILE));
  const onScreen = log2(max(abs(area), 1e-30))
    .mul(-0.5)
    .sub(log2(dotPixels.div(DOT_SHARE)))
    .toVar();
  return mix(min(onObject, onScreen), onScreen, sizedOnScreen);
}

/** The share that the dots of the plane across an axis cover. */
function dotsAcross(point: Value, axis: Value, cover: Value, onScreen: ScreenMap): Value {
  const u = normalize(anyTangent(axis)).toVar();
  const v = cross(axis, u).toVar();
  const plane = planeOnScreen(screenGradient(u, onScreen).toVar(), screenGradient(v, onScreen).toVar());
  const dense = log2(float(1).sub(max(cover, LEAST_DENSE_SHARE))).negate();
  const crowding = log2(dense).mul(0.5 * CROWDING);
  const [x, y, z] = SET_SHIFT;
  const shift = vec2(dot(axis, vec3(x, y, z)), dot(axis, vec3(y, z, x))).div(tilesPerUnit);
  const place = vec2(dot(point, u), dot(point, v)).add(shift).toVar();
  return dotsAt(place, plane, octaveOf(plane).add(crowding).toVar(), cover);
}

export function hatchLayer(h: HatchingParameters, tone: Value, builder: NodeBuilder): Value {
  const cover = coverOf(tone);
  const printed = cover.toVar();
  If(cover.greaterThan(0).and(cover.lessThan(1)), () => {
    const viewToAnchor = readViewToAnchor(builder);
    const blank = float(1).sub(cover).toVar();
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
        const covered = float(1).sub(pow(blank, share)).toVar();
        left.mulAssign(float(1).sub(dotsAcross(h.point, axis, covered, onScreen)));
      });
    });
    printed.assign(float(1).sub(left.mul(min(blank.div(1 - FILLING), 1))));
  });
  return printed;
}
