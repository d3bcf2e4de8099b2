/** Deformed vertices: the pass that writes them, and rotations as quaternions. */
import type { BufferGeometry } from 'three';
import type { Node } from 'three/webgpu';
import { blankIntegers, hatchingTexture, hatchingUniform, texelOf } from '../base/uniforms.js';
import { threeNodes, tsl, type Value } from '../base/values.js';
import { deformVertex } from '../chunks/vertex.js';

const { cross, determinant, dot, Fn, If, int, ivec2, mat3, max, normalize, normalLocal, select, uint } = tsl;
const { varyingProperty, vec2, vec3, vec4, vertexIndex } = tsl;

/** Counterpart of shaders/deformation.vert and .frag: writes each vertex, deformed by three.js' nodes, to its texel. */

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

/** Counterpart of shaders/perTriangle/turns.glsl: rotations as quaternions (x, y, z, w). */

/** The rotation of a 3 × 3 matrix as a quaternion; zero for one that mirrors or flattens. */
export function turnOf(matrix: Value): Value {
  const turn = vec4(0).toVar();
  If(determinant(matrix).greaterThan(0), () => {
    const x = normalize(matrix.element(0)).toVar();
    const second = matrix.element(1).toVar();
    const y = normalize(second.sub(x.mul(dot(x, second)))).toVar();
    const z = cross(x, y).toVar();
    // Four times the square of each component, minus 1; dividing by the largest component is the most accurate.
    const ofX = x.x.sub(y.y).sub(z.z).toVar();
    const ofY = y.y.sub(z.z).sub(x.x).toVar();
    const ofZ = z.z.sub(x.x).sub(y.y).toVar();
    const ofW = x.x.add(y.y).add(z.z).toVar();
    const largest = max(max(ofX, ofY), max(ofZ, ofW)).toVar();
    const most = largest.add(1).toVar();
    If(ofW.equal(largest), () => {
      turn.assign(vec4(y.z.sub(z.y), z.x.sub(x.z), x.y.sub(y.x), most));
    }).Else(() => {
      If(ofX.equal(largest), () => {
        turn.assign(vec4(most, x.y.add(y.x), x.z.add(z.x), y.z.sub(z.y)));
      }).Else(() => {
        If(ofY.equal(largest), () => {
          turn.assign(vec4(x.y.add(y.x), most, y.z.add(z.y), z.x.sub(x.z)));
        }).Else(() => {
          turn.assign(vec4(x.z.add(z.x), y.z.add(z.y), most, x.y.sub(y.x)));
        });
      });
    });
    turn.assign(normalize(turn));
  });
  return turn;
}

/** The matrix of the inverse rotation. */
export function turnBack(turn: Value): Value {
  const q = normalize(turn).toVar();
  const [x, y, z] = [q.x, q.y, q.z].map((component) => component.mul(2).toVar());
  const { w } = q;
  const columns = [
    vec3(y.mul(q.y).oneMinus().sub(z.mul(q.z)), x.mul(q.y).sub(z.mul(w)), x.mul(q.z).add(y.mul(w))),
    vec3(x.mul(q.y).add(z.mul(w)), x.mul(q.x).oneMinus().sub(z.mul(q.z)), y.mul(q.z).sub(x.mul(w))),
    vec3(x.mul(q.z).sub(y.mul(w)), y.mul(q.z).add(x.mul(w)), x.mul(q.x).oneMinus().sub(y.mul(q.y))),
  ];
  return mat3(...columns).toVar();
}
