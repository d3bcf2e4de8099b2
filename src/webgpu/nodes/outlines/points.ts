/** Outline primitives and their end points, read from textures. */
import { IS_EDGE, POINT_BITS, POINT_MASK, SPACING_STEPS } from '../../../mesh/bake/outlineLayout.js';
import { identity } from '../base/maths.js';
import { blankFloats, blankIntegers, blankPoses, hatchingTexture, hatchingUniform, texelOf } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { turnBack } from './poses.js';

const { abs, cross, dot, exp2, float, If, instanceIndex, int, ivec2, max, normalize, select, transpose, uint } = tsl;
const { uintBitsToFloat, unpackHalf2x16, unpackSnorm2x16, vec3, vec4 } = tsl;

/** Counterpart of shaders/outlines/points.glsl: the end points of outlines (src/mesh/bake/outlineLayout.ts). */

const outlinePoints = /* @__PURE__ */ hatchingTexture('outlinePoints', /* @__PURE__ */ blankIntegers());

/** Deformed positions, by vertex; w is 1 where `deformedTurns` has a rotation. */
const deformedPositions = /* @__PURE__ */ hatchingTexture('deformedPositions', /* @__PURE__ */ blankPoses());
/** The rotation by the skin, or the deformed normal. */
const deformedTurns = /* @__PURE__ */ hatchingTexture('deformedTurns', /* @__PURE__ */ blankPoses());
/** Whether the mesh deforms. A uniform, since deforming and rigid meshes may share a material. */
const isDeformed = /* @__PURE__ */ hatchingUniform('isDeformed', 'float');
export const radius: Value = /* @__PURE__ */ hatchingUniform('radius', 'float');

export interface OutlinePoint {
  /** Object space. */
  position: Value;
  /** Object space, at rest. */
  anchor: Value;
  /** Unit vector. */
  normal: Value;
  /** n·v: above 0 where the surface faces the eye. */
  facing: Value;
  /** Curvature along the line of sight, times the bounding radius. */
  bend: Value;
}

function octahedralNormal(word: Value): Value {
  const folded = unpackSnorm2x16(word).toVar();
  const z = abs(folded.x).oneMinus().sub(abs(folded.y)).toVar();
  const below = max(z.negate(), 0).toVar();
  const x = folded.x.add(select(folded.x.greaterThanEqual(0), below.negate(), below));
  const y = folded.y.add(select(folded.y.greaterThanEqual(0), below.negate(), below));
  return normalize(vec3(x, y, z));
}

export const towardsEye = (position: Value, eye: Value): Value => eye.xyz.sub(eye.w.mul(position));

export function readPoint(word: Value, eye: Value): OutlinePoint {
  const texel = texelOf(int(word.bitAnd(uint(POINT_MASK))).mul(2), outlinePoints).toVar();
  const place = outlinePoints.load(texel).toVar();
  const shape = outlinePoints.load(texel.add(ivec2(1, 0))).toVar();
  const anchor = vec3(uintBitsToFloat(place.x), uintBitsToFloat(place.y), uintBitsToFloat(place.z)).toVar();
  const position = anchor.toVar();
  const normal = octahedralNormal(place.w).toVar();
  const toRest = identity().toVar();
  If(isDeformed.greaterThan(0.5), () => {
    const vertex = texelOf(int(shape.w), deformedPositions).toVar();
    const posed = deformedPositions.load(vertex).toVar();
    const turn = deformedTurns.load(vertex).toVar();
    position.assign(posed.xyz);
    If(posed.w.greaterThan(0.5), () => {
      toRest.assign(turnBack(turn));
      normal.assign(transpose(toRest).mul(normal));
    }).Else(() => {
      // Morph targets change the normal only.
      If(dot(turn, turn).greaterThan(0), () => {
        normal.assign(normalize(turn.xyz));
      });
    });
  });
  const v = towardsEye(position, eye).toVar();
  const facing = dot(normal, v).toVar();
  const w = toRest.mul(v.sub(facing.mul(normal))).toVar();
  const kx = unpackHalf2x16(shape.x).toVar(); // xx xy
  const ky = unpackHalf2x16(shape.y).toVar(); // xz yy
  const kz = unpackHalf2x16(shape.z).toVar(); // yz zz
  const kw = vec3(dot(vec3(kx, ky.x), w), dot(vec3(kx.y, ky.y, kz.x), w), dot(vec3(ky.x, kz), w));
  const length2 = dot(w, w).toVar();
  const bend = select(length2.greaterThan(0), dot(w, kw).div(length2), float(0)).toVar();
  return { position, anchor, normal, facing, bend };
}

/** Counterpart of shaders/outlines/primitives.glsl: all primitives, or those in a list (src/mesh/bake/outlineLayout.ts). */

const outlinePrimitives = /* @__PURE__ */ hatchingTexture('outlinePrimitives', /* @__PURE__ */ blankIntegers());
const candidates = /* @__PURE__ */ hatchingTexture('candidates', /* @__PURE__ */ blankIntegers());
const instancePlaces = /* @__PURE__ */ hatchingTexture('instancePlaces', /* @__PURE__ */ blankFloats());
const isListed = /* @__PURE__ */ hatchingUniform('isListed', 'float');

/** Whether the mesh has instances. A uniform, since three.js would use one program for objects of both kinds. */
const isInstanced = /* @__PURE__ */ hatchingUniform('isInstanced', 'float');

/** The columns of the matrix of an instance. */
export type InstancePlace = readonly [x: Value, y: Value, z: Value, origin: Value];

/** The matrix of an instance by its number. */
export const placeOfInstanceNumber = (instance: Value): InstancePlace => {
  const column = (k: number): Value => instancePlaces.load(texelOf(instance.mul(4).add(k), instancePlaces)).xyz.toVar();
  return [column(0), column(1), column(2), column(3)];
};

/** A primitive by its index, and the matrix of its instance. */
export function readPrimitive(i: Value): { primitive: Value; instancePlace: InstancePlace } {
  const number = i.toVar();
  const instance = int(instanceIndex).toVar();
  const hasInstances = isInstanced.greaterThan(0.5).toVar();
  If(isListed.greaterThan(0.5), () => {
    const perTexel = select(hasInstances, int(2), int(4)).toVar();
    const texel = candidates.load(texelOf(i.div(perTexel), candidates)).toVar();
    const place = i.mod(perTexel).toVar();
    If(hasInstances, () => {
      number.assign(int(texel.element(place.mul(2))));
      instance.assign(int(texel.element(place.mul(2).add(1))));
    }).Else(() => {
      number.assign(int(texel.element(place)));
    });
  });
  const primitive = outlinePrimitives.load(texelOf(number, outlinePrimitives)).toVar();
  const column = (k: number): Value => vec3(...[0, 1, 2].map((row) => (row === k ? 1 : 0))).toVar();
  const instancePlace: InstancePlace = [column(0), column(1), column(2), column(3)];
  If(hasInstances, () => {
    for (const [k, target] of placeOfInstanceNumber(instance).entries()) instancePlace[k].assign(target);
  });
  return { primitive, instancePlace };
}

/** The number in the highest bits of two words. */
const highBits = (low: Value, high: Value): Value =>
  low.shiftRight(uint(POINT_BITS)).bitOr(high.shiftRight(uint(POINT_BITS)).shiftLeft(uint(4)));

export const flagsOf = (primitive: Value): Value => highBits(primitive.x, primitive.y);

/** The distance of the lines there, object units. */
export const spacingOf = (primitive: Value): Value =>
  radius.mul(exp2(float(highBits(primitive.z, primitive.w)).div(-SPACING_STEPS)));

export const hasFlag = (flags: Value, flag: number): Value => flags.bitAnd(uint(flag)).notEqual(uint(0));

export const isEdge = (primitive: Value): Value => hasFlag(flagsOf(primitive), IS_EDGE);

/** The rows of the inverse of a 3 × 3 matrix. */
function inverseRows([x, y, z]: InstancePlace): [Value, Value, Value] {
  const yz = cross(y, z).toVar();
  const determinant = dot(x, yz).toVar();
  return [yz.div(determinant), cross(z, x).div(determinant), cross(x, y).div(determinant)];
}

/** Whether an instance is hidden by a scale of 0. */
export const isScaledToNothing = ([x, y, z]: InstancePlace): Value => dot(x, x).add(dot(y, y)).add(dot(z, z)).equal(0);

/** The eye in the space of the instance. */
export function eyeOfInstance(eye: Value, instancePlace: InstancePlace): Value {
  const away = eye.xyz.sub(eye.w.mul(instancePlace[3])).toVar();
  const [a, b, c] = inverseRows(instancePlace);
  return vec4(dot(a, away), dot(b, away), dot(c, away), eye.w).toVar();
}

/** A position in the space of the mesh. @param position in the space of the instance */
export function placeOfInstance(position: Value, [x, y, z, origin]: InstancePlace): Value {
  return x.mul(position.x).add(y.mul(position.y)).add(z.mul(position.z)).add(origin);
}

/** A normal in the space of the mesh, not of unit length. */
export function normalOfInstance(normal: Value, instancePlace: InstancePlace): Value {
  const [a, b, c] = inverseRows(instancePlace);
  return vec3(a.mul(normal.x).add(b.mul(normal.y)).add(c.mul(normal.z)));
}
