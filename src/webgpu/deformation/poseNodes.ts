/** Counterpart of shaders/deformation.vert and .frag: writes each vertex, deformed by three.js' nodes, to its texel. */
import type { BufferGeometry } from 'three';
import type { Node } from 'three/webgpu';
import { blankIntegers } from '../nodes/base/blankTextures.js';
import { texelOf } from '../nodes/base/texelOf.js';
import { hatchingTexture } from '../nodes/base/textures.js';
import { hatchingUniform } from '../nodes/base/uniforms.js';
import { threeNodes, tsl, type Value } from '../nodes/base/values.js';
import { deformVertex } from '../nodes/chunks/deformVertex.js';
import { turnOf } from '../nodes/outlines/turns.js';

const { Fn, If, dot, int, ivec2, normalLocal, select, uint, varyingProperty, vec2, vec3, vec4, vertexIndex } = tsl;

/** Texture of the `pull` layout. */
const triangleVertices = /* @__PURE__ */ hatchingTexture('triangleVertices', /* @__PURE__ */ blankIntegers());
/** Size of the render targets, texels. */
const targetSize = /* @__PURE__ */ hatchingUniform('targetSize', 'vec2');

/** Position in object space; w is 1 if `vTurn` is a rotation. */
const vPosition = /* @__PURE__ */ varyingProperty('vec4', 'vPosition');
/** Rotation of a vertex by its skin, as a quaternion; the normal where there is no skin. */
const vTurn = /* @__PURE__ */ varyingProperty('vec4', 'vTurn');

/** The vertex of a corner, and whether the corner is the first one of that vertex. */
function vertexOfCorner(corner: Value): { vertex: Value; isFirst: Value } {
  const own = triangleVertices.load(texelOf(corner.div(3).mul(2), triangleVertices)).toVar();
  const k = corner.mod(3).toVar();
  return {
    vertex: int(own.element(k)).toVar(),
    isFirst: own.w.bitAnd(uint(1).shiftLeft(uint(k))).notEqual(uint(0)),
  };
}

/** The clip-space position of a texel. three.js flips the rows of render targets. */
function clipOf(texel: Value): Value {
  const place = vec2(texel).add(0.5).div(targetSize).mul(2).sub(1).toVar();
  return vec4(place.x, place.y.negate(), 0, 1);
}

const vertexNode = (hasIndex: boolean): Value =>
  Fn((builder) => {
    const { attributes, morphAttributes } = builder.geometry as BufferGeometry;
    const { position, skin } = deformVertex(builder);
    const turn = skin && !morphAttributes.position ? turnOf(skin) : null;
    const normal = attributes.normal ? normalLocal : vec3(0);
    if (turn) {
      const isTurn = dot(turn, turn).greaterThan(0).toVar();
      vPosition.assign(vec4(position, select(isTurn, 1, 0)));
      vTurn.assign(select(isTurn, turn, vec4(normal, 0)));
    } else {
      vPosition.assign(vec4(position, 0));
      vTurn.assign(vec4(normal, 0));
    }
    const corner = int(vertexIndex).toVar();
    const width = int(targetSize.x).toVar();
    const texel = (vertex: Value): Value => ivec2(vertex.mod(width), vertex.div(width));
    if (hasIndex) return clipOf(texel(corner));
    const { vertex, isFirst } = vertexOfCorner(corner);
    const clip = vec4(2, 2, 2, 1).toVar();
    If(isFirst, () => {
      clip.assign(clipOf(texel(vertex)));
    });
    return clip;
  })();

/** The nodes of a pass that renders poses. */
export interface PoseNodes {
  readonly vertex: Node<'vec4'>;
  readonly fragment: Node;
}

const poseNodes = (hasIndex: boolean): PoseNodes => ({
  vertex: vertexNode(hasIndex) as unknown as Node<'vec4'>,
  fragment: (threeNodes.outputStruct as (...members: unknown[]) => Node)(vPosition, vTurn),
});

/** Places vertices by their index: for geometries with an index. */
export const OF_VERTICES: PoseNodes = /* @__PURE__ */ poseNodes(true);
/** Places the first corner of each vertex: for geometries with the layout `pull`. */
export const OF_CORNERS: PoseNodes = /* @__PURE__ */ poseNodes(false);
