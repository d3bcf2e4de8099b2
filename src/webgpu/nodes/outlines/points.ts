/** Counterpart of shaders/outlines/points.glsl: the end points of outlines (src/mesh/bake/outlineLayout.ts). */
import { POINT_MASK } from '../../../mesh/bake/outlineLayout.js';
import { blankIntegers, blankPoses } from '../base/blankTextures.js';
import { identity } from '../base/matrices.js';
import { texelOf } from '../base/texelOf.js';
import { hatchingTexture } from '../base/textures.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { turnBack } from './turns.js';

const { If, abs, dot, float, int, ivec2, max, normalize, select, transpose, uint, uintBitsToFloat } = tsl;
const { unpackHalf2x16, unpackSnorm2x16, vec3 } = tsl;

const outlinePoints = /* @__PURE__ */ hatchingTexture('outlinePoints', /* @__PURE__ */ blankIntegers());

/** Deformed positions, by vertex; w is 1 where `deformedTurns` has a rotation. */
const deformedPositions = /* @__PURE__ */ hatchingTexture('deformedPositions', /* @__PURE__ */ blankPoses());
/** The rotation by the skin, or the deformed normal. */
const deformedTurns = /* @__PURE__ */ hatchingTexture('deformedTurns', /* @__PURE__ */ blankPoses());
/** Whether the mesh deforms. A uniform, since deforming and rigid meshes may share a material. */
const isDeformed = /* @__PURE__ */ hatchingUniform('isDeformed', 'float');

/** Radius of the bounding sphere, object units. */
export const radius: Value = /* @__PURE__ */ hatchingUniform('radius', 'float');

export interface OutlinePoint {
  /** Object space. */
  position: Value;
  /** Object space, at rest. */
  anchor: Value;
  /** Of unit length. */
  normal: Value;
  /** n·v: above 0 where the surface faces the eye. */
  facing: Value;
  /** Curvature along the line of sight, times the bounding radius. */
  bend: Value;
}

export function octahedralNormal(word: Value): Value {
  const folded = unpackSnorm2x16(word).toVar();
  const z = float(1).sub(abs(folded.x)).sub(abs(folded.y)).toVar();
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
      // With morph targets only the normal is known.
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
