/** three's nodes, with types that say no more than that a node is a value. Those of three.js follow each operation, and lose it half way. */
import { REVISION } from 'three';
import * as TSL from 'three/tsl';
import type { NodeBuilder } from 'three/webgpu';
import { newEnough } from './newEnough.js';

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
  /** Has it computed here, and kept. */
  toVar(name?: string): Value;
  assign(value: Input): void;
  addAssign(value: Input): void;
  mulAssign(value: Input): void;
}

/** A texture, to be read. */
export interface TextureValue extends Value {
  /** The texel at integers. */
  load(texel: Value): Value;
  sample(coordinates: Value): TextureValue;
  level(level: Input): TextureValue;
}

interface Branches {
  Else(then: () => void): void;
}

interface Shading
  extends Record<
    | (
        | 'float'
        | 'int'
        | 'uint'
        | 'bool'
        | 'vec2'
        | 'vec3'
        | 'vec4'
        | 'ivec2'
        | 'ivec3'
        | 'uvec3'
        | 'uvec4'
        | 'mat3'
        | 'mat4'
      )
    | (
        | 'abs'
        | 'ceil'
        | 'floor'
        | 'round'
        | 'fract'
        | 'sign'
        | 'sqrt'
        | 'inverseSqrt'
        | 'exp'
        | 'exp2'
        | 'log2'
        | 'sin'
        | 'cos'
      )
    | ('dFdx' | 'dFdy' | 'fwidth')
    | ('min' | 'max' | 'clamp' | 'mix' | 'step' | 'smoothstep' | 'pow' | 'select')
    | ('add' | 'cross' | 'distance' | 'dot' | 'length' | 'normalize' | 'determinant' | 'inverse' | 'transpose')
    | ('floatBitsToInt' | 'floatBitsToUint' | 'intBitsToFloat' | 'varying')
    | ('textureSize' | 'transformNormalToView' | 'uintBitsToFloat' | 'unpackHalf2x16' | 'unpackSnorm2x16'),
    Operation
  > {
  attribute(name: string, type: string): Value;
  /** What an object has under this name. */
  reference(name: string, type: string): Value;
  referenceBuffer(name: string, type: string, count: number): Value;
  /** What moves a vertex of an object, as three's own materials have it moved. */
  batch(object: object): void;
  instancedMesh(object: object): void;
  morphReference(object: object): void;
  skinning(object: object): void;
  /** Runs when a shader is built. */
  Fn(build: (builder: NodeBuilder) => Value): () => Value;
  If(condition: Value, then: () => void): Branches;
  Loop(range: object, body: (counters: Record<string, Value>) => void): void;
  Break(): void;
  Discard(condition: Value): void;
  /** A variable of a stage that anything in it may read. */
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
 * three's node functions, typed as three.js has them. No other file imports them: those of older versions are not all there, which would end a page
 * before it could be said.
 */
export const threeNodes: typeof TSL = /* @__PURE__ */ newEnough(TSL, REVISION);

/** The same, typed by values. */
export const tsl: Shading = threeNodes as unknown as Shading;
