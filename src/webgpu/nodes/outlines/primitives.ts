/** Counterpart of shaders/outlines/primitives.glsl: all primitives, or those in a list (src/mesh/bake/outlineLayout.ts). */
import { POINT_BITS } from '../../../mesh/bake/outlineLayout.js';
import { IS_EDGE } from '../../../mesh/features/edgeFlags.js';
import { blankFloats, blankIntegers } from '../base/blankTextures.js';
import { texelOf } from '../base/texelOf.js';
import { hatchingTexture } from '../base/textures.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { If, cross, dot, instanceIndex, int, select, uint, vec3, vec4 } = tsl;

const outlinePrimitives = /* @__PURE__ */ hatchingTexture('outlinePrimitives', /* @__PURE__ */ blankIntegers());
/** The list of primitives, four per texel; with instances two, each with the index of its instance. */
const candidates = /* @__PURE__ */ hatchingTexture('candidates', /* @__PURE__ */ blankIntegers());
/** Instance matrices, one column per texel. */
const instancePlaces = /* @__PURE__ */ hatchingTexture('instancePlaces', /* @__PURE__ */ blankFloats());
const isListed = /* @__PURE__ */ hatchingUniform('isListed', 'float');

/** Whether the mesh has instances. A uniform, since three.js would use one program for objects of both kinds. */
const isInstanced = /* @__PURE__ */ hatchingUniform('isInstanced', 'float');

/** The columns of the matrix of an instance. */
export type InstancePlace = readonly [x: Value, y: Value, z: Value, origin: Value];

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
    for (const [k, target] of instancePlace.entries()) {
      target.assign(instancePlaces.load(texelOf(instance.mul(4).add(k), instancePlaces)).xyz);
    }
  });
  return { primitive, instancePlace };
}

export const flagsOf = (primitive: Value): Value =>
  primitive.x.shiftRight(uint(POINT_BITS)).bitOr(primitive.y.shiftRight(uint(POINT_BITS)).shiftLeft(uint(4)));

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
