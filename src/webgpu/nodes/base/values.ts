import { REVISION } from 'three';
import * as TSL from 'three/tsl';
import type { NodeBuilder } from 'three/webgpu';

/** The oldest version of three.js, after its `0.`, that has all the nodes that are used here. */
const OLDEST = 186;

/**
 * Returns the nodes of three.js if their version is new enough.
 *
 * @param revision the version after its `0.`, such as `187` or `187dev`
 * @throws Error that says what to do
 */
export function newEnough<Nodes>(nodes: Nodes, revision: string): Nodes {
  if (Number.parseInt(revision, 10) >= OLDEST) return nodes;
  throw new Error(
    `three-hatching/webgpu needs three.js 0.${OLDEST} or newer, but this is 0.${revision}. Update three.js, or draw with WebGLRenderer and import from 'three-hatching', which works with any version from 0.170 on.`,
  );
}

/** three.js' nodes with one type for all values: the types of three.js follow each operation, and are lost half way. */

/** A node, or a number that becomes one. */
export type Input = Value | number | boolean;

type Operation = (...others: Input[]) => Value;

/** A value of a shader: a number, a vector or a matrix. */
export interface Value
  extends Record<
      | ('add' | 'sub' | 'mul' | 'div' | 'mod' | 'negate' | 'oneMinus' | 'pow2' | 'element')
      | ('equal' | 'notEqual' | 'lessThan' | 'lessThanEqual' | 'greaterThan' | 'greaterThanEqual')
      | ('and' | 'or' | 'not' | 'bitAnd' | 'bitOr' | 'bitXor' | 'shiftLeft' | 'shiftRight'),
      Operation
    >,
    Record<'x' | 'y' | 'z' | 'w' | 'xy' | 'zw' | 'xz' | 'yw' | 'xyz' | 'yzw' | 'yzx' | 'zxy', Value> {
  /** Stores the value in a variable. */
  toVar(name?: string): Value;
  assign(value: Input): void;
  addAssign(value: Input): void;
  mulAssign(value: Input): void;
}

/** A texture node. */
export interface TextureValue extends Value {
  /** The texel at integer coordinates. */
  load(texel: Value): Value;
  sample(coordinates: Value): TextureValue;
  level(level: Input): TextureValue;
  /** The same texture, read so many levels coarser than the screen shows it. */
  bias(levels: Input): TextureValue;
}

interface Branches {
  Else(then: () => void): void;
}

type Types = 'float' | 'int' | 'uint' | 'bool' | 'vec2' | 'vec3' | 'vec4' | 'ivec2' | 'ivec3' | 'uvec3' | 'uvec4';
type Matrices = 'mat3' | 'mat4' | 'determinant' | 'inverse' | 'transpose';
type Rounding = 'abs' | 'ceil' | 'floor' | 'round' | 'fract' | 'sign' | 'step' | 'smoothstep' | 'min' | 'max' | 'clamp';
type Powers = 'sqrt' | 'inverseSqrt' | 'exp' | 'exp2' | 'log2' | 'pow' | 'sin' | 'cos';
type Vectors = 'cross' | 'distance' | 'dot' | 'length' | 'normalize' | 'transformNormalToView';
type Bits = 'floatBitsToInt' | 'floatBitsToUint' | 'intBitsToFloat' | 'uintBitsToFloat';
type Packed = 'unpackHalf2x16' | 'unpackSnorm2x16';
type OfStages = 'dFdx' | 'dFdy' | 'fwidth' | 'varying' | 'textureSize';

interface Shading
  extends Record<
    Types | Matrices | Rounding | Powers | Vectors | Bits | Packed | OfStages | 'add' | 'mix' | 'select',
    Operation
  > {
  attribute(name: string, type: string): Value;
  /** A property of an object. */
  reference(name: string, type: string): Value;
  referenceBuffer(name: string, type: string, count: number): Value;
  /** Nodes that move the vertex of an object, as in three.js' materials. */
  batch(object: object): void;
  instancedMesh(object: object): void;
  morphReference(object: object): void;
  skinning(object: object): void;
  /** Calls `build` when a shader is built. */
  Fn(build: (builder: NodeBuilder) => Value): () => Value;
  If(condition: Value, then: () => void): Branches;
  Loop(range: object, body: (counters: Record<string, Value>) => void): void;
  Break(): void;
  Discard(condition: Value): void;
  /** A variable that all code of a shader stage can read. */
  property(type: string, name: string): Value;
  varyingProperty(type: string, name: string): Value;
  readonly batchIndirectIndex: Value;
  readonly normalFlat: Value;
  readonly normalLocal: Value;
  readonly positionGeometry: Value;
  readonly positionLocal: Value;
  readonly normalGeometry: Value;
  readonly normalView: Value;
  readonly positionView: Value;
  readonly positionViewDirection: Value;
  readonly positionWorld: Value;
  readonly diffuseColor: Value;
  readonly frontFacing: Value;
  readonly materialEmissive: Value;
  readonly cameraFar: Value;
  readonly cameraNear: Value;
  readonly cameraProjectionMatrix: Value;
  readonly cameraViewMatrix: Value;
  readonly instanceIndex: Value;
  readonly modelNormalMatrix: Value;
  readonly modelViewMatrix: Value;
  readonly screenCoordinate: Value;
  readonly screenSize: Value;
  readonly vertexIndex: Value;
}

/**
 * three.js' node functions with their own types. No other file may import them: older versions lack some, and an import error would come
 * before the message about the version.
 */
export const threeNodes: typeof TSL = /* @__PURE__ */ newEnough(TSL, REVISION);

/** The same functions, with the type `Value`. */
export const tsl: Shading = threeNodes as unknown as Shading;
