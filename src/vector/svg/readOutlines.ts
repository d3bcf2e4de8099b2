import {
  type BufferGeometry,
  type Camera,
  DataUtils,
  type Material,
  Matrix3,
  Matrix4,
  type Mesh,
  Vector3,
} from 'three';
import type { OutlineData } from '../../material/geometry/OutlineData.js';
import type { HatchingOutlineMaterial } from '../../material/outlines/HatchingOutlineMaterial.js';
import { opacityOf, showsBack } from '../../material/outlines/surfaceRules.js';
import {
  BORDER,
  CONTRARY,
  CORNER_AT_END,
  CORNER_AT_START,
  CREASE,
  MATERIAL_BORDER,
  POINT_BITS,
  POINT_MASK,
  POINT_WORDS,
  PRIMITIVE_WORDS,
  SPACING_STEPS,
  unpackPoints,
} from '../../mesh/bake/outlineLayout.js';
import { asPhase } from '../../mesh/phases.js';
import type { FeatureEdge, OutlineLook, OutlineMesh } from '../outlines/OutlineMesh.js';
import type { ObjectFading } from '../shading/fading.js';
import { alphaTestOf } from './PaintReader.js';
import type { PosedVertices } from './posedVertices.js';
import { leftBehind } from './seenThrough.js';
import { rowsOf } from './surfaceFrame.js';
import { weldBoth, weldPoints } from './weldPoints.js';

/** Triangles, edges and points per step. */
const CHUNK = 4096;

/**
 * The look of outlines. Lines do not fade: half transparent ones are half as wide, which takes the same ink.
 *
 * @param surface material of the surface
 * @param geometry of the surface
 * @param hasMaterials whether the mesh has several materials, whose borders are drawn
 * @param fading of the mesh
 */
export function outlineLookOf(
  material: HatchingOutlineMaterial,
  surface: Material,
  geometry: BufferGeometry,
  hasMaterials: boolean,
  fading: ObjectFading | null,
): OutlineLook {
  const { contours, innerContours, borders, creases, materialBorders, intersections, suggestiveContours, lit, shade } =
    material.weights;
  const { outlineWidth, taper, lostEdges, accents, overshoot, wobble, hidden } = material;
  const opacity = Math.min(opacityOf(material), opacityOf(surface, geometry));
  return {
    ...{ width: outlineWidth * opacity, opacity },
    materialBorders: hasMaterials ? materialBorders : 0,
    intersections: material.intersections ? intersections : 0,
    shadeWeights: [lit, shade],
    ...{ contours, innerContours, borders, creases, suggestiveContours, taper, lostEdges },
    ...{ accents, overshoot, wobble, fading, hidden },
    isCutOut: alphaTestOf(surface) > 0 && surface.depthWrite && leftBehind(surface, geometry) === 0,
    showsBack: showsBack(surface),
  };
}

/** A placement of a mesh, with its pose there. */
export interface OutlinedCopy {
  toWorld: Matrix4;
  posed: PosedVertices;
}

/** Reads the mesh that outlines are found on. Yields its progress. */
export function* readOutlines(
  mesh: Mesh,
  data: OutlineData,
  { toWorld, posed }: OutlinedCopy,
  camera: Camera,
): Generator<number, OutlineMesh, void> {
  const points = data.points.image.data as Uint32Array<ArrayBuffer>;
  const primitives = data.primitives.image.data as Uint32Array;
  const { triangleCount, edgeCount } = data;
  const triangles = new Uint32Array(3 * triangleCount);
  const spacings = new Float32Array(triangleCount);
  for (let t = 0; t < triangleCount; t++) {
    if (t % CHUNK === CHUNK - 1) yield (0.2 * t) / triangleCount;
    for (let k = 0; k < 3; k++) triangles[3 * t + k] = primitives[PRIMITIVE_WORDS * t + k] & POINT_MASK;
    spacings[t] = spacingAt(primitives, PRIMITIVE_WORDS * t, data.radius);
  }
  const first = PRIMITIVE_WORDS * triangleCount;
  const edges: FeatureEdge[] = [];
  for (let i = 0; i < edgeCount; i++) {
    if (i % CHUNK === CHUNK - 1) yield 0.2;
    edges.push(edgeAt(primitives, first + PRIMITIVE_WORDS * i, data.radius));
  }
  yield 0.2;
  const pointCount = pointCountOf(triangles, edges);
  yield 0.25;
  const atRest = unpackPoints(points, pointCount);
  const curvatures = yield* asPhase(curvaturesOf(points, pointCount), 0.3, 0.5);
  const { positions, normals } = posePoints(mesh, points, { ...atRest, curvatures }, posed);
  const anchors = atRest.positions;
  const placesAlong = (of: ArrayLike<number>) => weldPoints(of.length / 3, (point, axis) => of[3 * point + axis]);
  yield 0.5;
  const places = yield* asPhase(placesAlong(anchors), 0.5, 1);
  return {
    ...{ positions, normals, anchors, curvatures, triangles, spacings, edges },
    placeOf: positions === anchors ? places : weldBoth(places, yield* placesAlong(positions)),
    radius: data.radius || 1,
    toWorld: [...toWorld.elements],
    normalToWorld: rowsOf(new Matrix3().getNormalMatrix(toWorld)),
    scale: Math.cbrt(Math.abs(toWorld.determinant())) || 1,
    eye: eyeIn(toWorld, camera),
  };
}

/** The number of points: textures are padded to whole rows, so it is derived from the greatest index. */
function pointCountOf(triangles: Uint32Array, edges: readonly FeatureEdge[]): number {
  let most = -1;
  for (let i = 0; i < triangles.length; i++) most = Math.max(most, triangles[i]);
  for (const { leftStart, leftEnd, rightStart, rightEnd } of edges)
    most = Math.max(most, leftStart, leftEnd, rightStart, rightEnd);
  return most + 1;
}

/** The number in the highest bits of two words. */
const highBits = (words: Uint32Array, o: number): number =>
  (words[o] >>> POINT_BITS) | ((words[o + 1] >>> POINT_BITS) << 4);

/** The distance of the lines at a primitive. @param radius of the bounding sphere */
const spacingAt = (words: Uint32Array, o: number, radius: number): number =>
  radius * 2 ** (-highBits(words, o + 2) / SPACING_STEPS);

function edgeAt(words: Uint32Array, o: number, radius: number): FeatureEdge {
  const flags = highBits(words, o);
  return {
    leftStart: words[o] & POINT_MASK,
    leftEnd: words[o + 1] & POINT_MASK,
    rightStart: words[o + 2] & POINT_MASK,
    rightEnd: words[o + 3] & POINT_MASK,
    isBorder: (flags & BORDER) !== 0,
    isCrease: (flags & CREASE) !== 0,
    isMaterialBorder: (flags & MATERIAL_BORDER) !== 0,
    isIntersection: false,
    isContrary: (flags & CONTRARY) !== 0,
    isCornerAtStart: (flags & CORNER_AT_START) !== 0,
    isCornerAtEnd: (flags & CORNER_AT_END) !== 0,
    spacing: spacingAt(words, o, radius),
  };
}

function* curvaturesOf(words: Uint32Array, count: number): Generator<number, Float32Array, void> {
  const curvatures = new Float32Array(6 * count);
  for (let p = 0; p < count; p++) {
    if (p % CHUNK === CHUNK - 1) yield p / count;
    for (let pair = 0; pair < 3; pair++) {
      const word = words[POINT_WORDS * p + 4 + pair];
      curvatures[6 * p + 2 * pair] = DataUtils.fromHalfFloat(word & 0xffff);
      curvatures[6 * p + 2 * pair + 1] = DataUtils.fromHalfFloat(word >>> 16);
    }
  }
  return curvatures;
}

/** The eye in the space of a mesh: a position with w = 1, or a direction with w = 0. */
function eyeIn(toWorld: Matrix4, camera: Camera): OutlineMesh['eye'] {
  const toObject = new Matrix4().copy(toWorld).invert();
  if (camera.projectionMatrix.elements[15] === 1) {
    const { x, y, z } = new Vector3().setFromMatrixColumn(camera.matrixWorld, 2).transformDirection(toObject);
    return [x, y, z, 0];
  }
  const { x, y, z } = new Vector3().setFromMatrixPosition(camera.matrixWorld).applyMatrix4(toObject);
  return [x, y, z, 1];
}

/** Points of outlines: positions, unit normals, and six numbers of the curvature each. */
export interface OutlinePoints {
  positions: Float32Array;
  normals: Float32Array;
  curvatures: Float32Array;
}

/** The word of a point that holds the index of its vertex. */
const VERTEX_WORD = 7;

/**
 * Deforms points of outlines as shaders/outlines/points.glsl does: with skinning alone their normals rotate; with morph targets only the
 * normals of vertices are known. Rotates the curvatures in place.
 *
 * @param words that the points were read from
 */
function posePoints(
  { geometry }: Mesh,
  words: Uint32Array,
  { positions, normals, curvatures }: OutlinePoints,
  posed: PosedVertices,
): Pick<OutlineMesh, 'positions' | 'normals'> {
  // The layout of corners has no vertices to take the pose from; it does not deform on the canvas either.
  if (!posed.toRest || geometry.userData.hatching?.layout === 'corner') return { positions, normals };
  const hasMorphs = geometry.morphAttributes.position !== undefined;
  const moved = { positions: new Float64Array(positions.length), normals: Float64Array.from(normals) };
  const vector = new Vector3();
  for (let p = 0; 3 * p < positions.length; p++) {
    const vertex = words[POINT_WORDS * p + VERTEX_WORD];
    for (let k = 0; k < 3; k++) moved.positions[3 * p + k] = posed.positions[3 * vertex + k];
    const turn = hasMorphs ? null : turnOf(posed.toRest, vertex);
    if (turn) {
      vector.fromArray(normals, 3 * p).applyMatrix3(turn);
      turnTensor(curvatures, 6 * p, turn);
    } else if (posed.normals) {
      vector.fromArray(posed.normals, 3 * vertex).normalize();
      if (vector.lengthSq() === 0) continue;
    }
    vector.toArray(moved.normals as unknown as number[], 3 * p);
  }
  return moved;
}

/** The rotation of a vertex by its skin (shaders/perTriangle/turns.glsl); null for one that mirrors or flattens. */
function turnOf(toRest: Float64Array, vertex: number): Matrix3 | null {
  const skin = new Matrix3().fromArray(toRest, 9 * vertex);
  if (!(skin.determinant() > 0)) return null;
  const [x, y, z] = [new Vector3(), new Vector3(), new Vector3()];
  new Matrix4().setFromMatrix3(skin.invert()).extractBasis(x, y, z);
  x.normalize();
  y.addScaledVector(x, -x.dot(y)).normalize();
  z.crossVectors(x, y);
  return new Matrix3().setFromMatrix4(new Matrix4().makeBasis(x, y, z));
}

/** Rotates a symmetric tensor, xx xy xz yy yz zz. */
function turnTensor(numbers: Float32Array, o: number, turn: Matrix3): void {
  const [xx, xy, xz, yy, yz, zz] = numbers.subarray(o, o + 6);
  const tensor = new Matrix3().set(xx, xy, xz, xy, yy, yz, xz, yz, zz);
  const { elements: e } = tensor.premultiply(turn).multiply(new Matrix3().copy(turn).transpose());
  numbers.set([e[0], e[3], e[6], e[4], e[7], e[8]], o);
}
