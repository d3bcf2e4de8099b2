import {
  Box3,
  type BufferGeometry,
  Color,
  DoubleSide,
  type Material,
  Matrix3,
  Matrix4,
  Mesh,
  type Object3D,
  type Texture,
  Vector2,
  Vector3,
} from 'three';
import { smallAmong } from '../../../mesh/smallParts.js';
import { placements } from '../../drawing/meshes.js';
import { partNames } from '../common/partNames.js';
import { FAR } from '../mesh/fitModel.js';
import { checkReadTriangles, type MeshParts, type PictureRange, type PlainMesh } from '../mesh/PlainMesh.js';
import type { PictureLink, WantedPicture } from '../pictures/meshPictures.js';
import { materialName, meshNames } from './meshNames.js';
import { mirroredBy, reflectedColor } from './mirroredBy.js';
import { repairScene } from './repairGeometry.js';
import { resolveAlpha } from './resolveAlpha.js';

/**
 * Merges all meshes below `root`, in their places and saved poses, to one mesh, which needs one bake and one draw call. Colours of
 * materials and vertices become vertex colours; non-finite values are repaired. See-through parts get their own ranges. Meshes are the
 * parts of the result; those of a scene of one mesh are its named runs of triangles, or else its materials. Where materials differ in
 * colour the mesh has a range for each colour, so that each has a tone and its borders have lines.
 *
 * @param pictures if given, receives the textures of base colours, and the mesh has one range per texture; otherwise textures are left out
 * @param toMesh if given, receives the matrix from scene space to mesh space
 * @param notes if given, receives notes for the caption
 * @param hasSides whether the materials say which sides are drawn
 * @throws ModelError if there are no triangles, or too many
 */
export function mergeScene(
  root: Object3D,
  pictures?: WantedPicture[],
  toMesh?: Matrix4,
  notes?: string[],
  hasSides = false,
): PlainMesh {
  root.updateMatrixWorld(true);
  repairScene(root);
  const alphaNotes = resolveAlpha(root);
  notes?.push(...alphaNotes);
  const parts = placedParts(root, pictures, hasSides);
  const toOrigin = nearOrigin(parts);
  if (toOrigin) toMesh?.copy(toOrigin);
  if (toOrigin) for (const part of parts) part.matrix = part.matrix.clone().premultiply(toOrigin);
  const pieces: PlacedPiece[] = parts.flatMap((part) => part.pieces.map((piece) => ({ part, piece })));
  const cornerCount = pieces.reduce((sum, { piece }) => sum + piece.count, 0);
  checkReadTriangles(cornerCount / 3);
  const vertexCount = parts.reduce((sum, part) => sum + part.vertexCount, 0);
  const positions = new Float32Array(3 * vertexCount);
  const normals = parts.some(({ mesh }) => hasUsableNormals(mesh)) ? new Float32Array(3 * vertexCount) : null;
  const colors = pieces.some(({ part, piece }) => isColored(part.mesh, piece))
    ? new Float32Array(3 * vertexCount)
    : null;
  const uvs = pictures?.length ? new Float32Array(2 * vertexCount) : null;
  for (const part of parts) {
    writeVertices(part, positions, normals);
    if (colors) writeColors(part, colors);
    if (uvs) writeUvs(part, uvs);
  }

  const indices = new Uint32Array(cornerCount);
  const ranges: PictureRange[] = [];
  let corner = 0;
  const paints = paintsOf(pieces.map(({ piece }) => piece));
  const placeOf = (piece: Piece): number => Math.max(0, paints.indexOf(paintOf(piece)));
  const small = paints.length > 1 ? smallAmongPieces(pieces, positions) : new Set<Piece>();
  const rangeOf = (piece: Piece): number =>
    2 * ((STEPS_OF_METAL * drawnAs(piece) + piece.metal) * MOST_PAINTS + (piece.isSeeThrough ? 0 : placeOf(piece))) +
    Number(small.has(piece));
  // Sorted, so that the triangles of each picture and paint form one range.
  let before: number | undefined;
  for (const { part, piece } of pieces.sort((a, b) => rangeOf(a.piece) - rangeOf(b.piece))) {
    const end = writeIndices(part, piece, indices, corner);
    const { picture, isSeeThrough, metal } = piece;
    const sides = hasSides && { isOneSided: piece.isOneSided };
    const range = rangeOf(piece);
    const paint = paints.length > 1 && !isSeeThrough && { paint: paints[placeOf(piece)] };
    if (range === before) ranges[ranges.length - 1].count += end - corner;
    else
      ranges.push({
        ...{ start: corner, count: end - corner, picture },
        ...(isSeeThrough && { isSeeThrough }),
        ...sides,
        ...(metal > 0 && { mirrors: metal / (STEPS_OF_METAL - 1) }),
        ...paint,
        ...(small.has(piece) && { isOfSmallParts: true }),
      });
    corner = end;
    before = range;
  }
  const hasRanges =
    uvs !== null || ranges.length > 1 || ranges.some(({ isSeeThrough, mirrors }) => isSeeThrough || mirrors);
  const named = namedParts(parts, vertexCount, root);
  return {
    ...{ positions, normals, colors, indices },
    ...(uvs && { uvs }),
    ...(hasRanges ? { ranges } : hasSides && { isOneSided: ranges[0].isOneSided }),
    ...(named && { parts: named }),
  };
}

/** Consecutive triangles of a mesh that have a name in the file, from a corner on up to the next run. */
export interface NamedRun {
  start: number;
  name: string;
  /** The part that it belongs to: a name may be that of several parts. */
  part: number;
}

/** Corners of a mesh with one material, and in one named run. */
interface Piece {
  start: number;
  count: number;
  material: Material | undefined;
  /** Its run; undefined for a mesh without runs. */
  run: NamedRun | undefined;
  /** The index of its picture, or -1. */
  picture: number;
  isSeeThrough: boolean;
  /** How much its metal mirrors, in steps; 0 for all but smooth metal. */
  metal: number;
  /** Whether only its front is drawn, where materials say it. */
  isOneSided: boolean;
  /** The index of its first corner among those of all pieces. */
  first: number;
}

/** The order of ranges but for their paint. See-through pieces come last. */
const drawnAs = ({ picture, isSeeThrough, isOneSided }: Piece): number =>
  2 * (isSeeThrough ? 2 ** 32 : picture) + Number(isOneSided);

/** In how many steps metal differs, each with a range of its own. */
const STEPS_OF_METAL = 5;

const stepOfMetal = (material: Material | undefined): number =>
  material ? Math.round((STEPS_OF_METAL - 1) * mirroredBy(material)) : 0;

/** The greatest number of paints with ranges of their own: each range is a call to draw. The rest has that of the first. */
const MOST_PAINTS = 32;

/** A name for the colour of a piece. */
const paintOf = (piece: Piece): string => new Color(...pieceColor(piece)).getHexString();

/** A piece with the mesh that it is of, in its place. */
interface PlacedPiece {
  part: Part;
  piece: Piece;
}

/** The opaque pieces without pictures that are too small for strokes, if there are many. */
function smallAmongPieces(placed: readonly PlacedPiece[], positions: Float32Array): Set<Piece> {
  const whole = new Box3().setFromArray(positions);
  const sizes = placed.map(({ part, piece }) => {
    const first = part.firstVertex + (part.isUnshared ? piece.first : 0);
    const { min, max } = box.setFromArray(
      positions.subarray(3 * first, 3 * (first + (part.isUnshared ? piece.count : part.vertexCount))),
    );
    return min.distanceTo(max);
  });
  const isSmall = smallAmong(sizes, whole.min.distanceTo(whole.max));
  const drawn = placed.filter(({ piece }, i) => isSmall[i] && piece.picture === -1 && !piece.isSeeThrough);
  return new Set(drawn.map(({ piece }) => piece));
}

const box = new Box3();

/** The paints with the most corners, the most first. */
function paintsOf(pieces: readonly Piece[]): string[] {
  const corners = new Map<string, number>();
  for (const piece of pieces)
    if (!piece.isSeeThrough) corners.set(paintOf(piece), (corners.get(paintOf(piece)) ?? 0) + piece.count);
  return [...corners.keys()].sort((a, b) => corners.get(b)! - corners.get(a)!).slice(0, MOST_PAINTS);
}

/** A mesh with one of its matrices. */
interface Part {
  mesh: Mesh;
  matrix: Matrix4;
  pieces: Piece[];
  /** Whether every corner has its own vertex, because materials that share vertices may differ in colour. */
  isUnshared: boolean;
  firstVertex: number;
  vertexCount: number;
}

function placedParts(root: Object3D, pictures: WantedPicture[] | undefined, hasSides: boolean): Part[] {
  const parts: Part[] = [];
  let firstVertex = 0;
  root.traverseVisible((object) => {
    if (!(object instanceof Mesh) || !object.geometry.getAttribute('position')) return;
    const pieces = piecesOf(object, pictures, hasSides);
    const isUnshared = pieces.length > 1;
    const last = pieces.at(-1);
    const corners = last ? last.first + last.count : 0;
    const vertexCount = isUnshared ? corners : object.geometry.getAttribute('position').count;
    for (const matrix of placements(object)) {
      parts.push({ mesh: object, matrix, pieces, isUnshared, firstVertex, vertexCount });
      firstVertex += vertexCount;
    }
  });
  return parts;
}

/** The drawn corners by material. As in three.js, groups count only with an array of materials. */
function piecesOf(
  { geometry, material, userData }: Mesh,
  pictures: WantedPicture[] | undefined,
  hasSides: boolean,
): Piece[] {
  const drawn = drawnCorners(geometry);
  const materials = Array.isArray(material) ? material : [material];
  const groups = Array.isArray(material) && geometry.groups.length > 0 ? geometry.groups : [{ ...drawn }];
  const pieces: Piece[] = [];
  let first = 0;
  for (const group of groups as BufferGeometry['groups']) {
    const start = Math.max(group.start, drawn.start);
    const available = Math.min(group.start + group.count, drawn.start + drawn.count) - start;
    const count = available - (available % 3);
    const groupMaterial = materials[group.materialIndex ?? 0] as Material | undefined;
    if (!(count > 0) || groupMaterial?.visible === false) continue;
    const picture = pictureOf(geometry, groupMaterial, pictures);
    const isSeeThrough = groupMaterial?.transparent ?? false;
    const metal = isSeeThrough ? 0 : stepOfMetal(groupMaterial);
    const isOneSided = hasSides && groupMaterial?.side !== DoubleSide;
    for (const run of runsIn(userData.runs, start, count)) {
      pieces.push({ ...run, material: groupMaterial, picture, isSeeThrough, metal, isOneSided, first });
      first += run.count;
    }
  }
  return pieces;
}

/** Splits a range of corners by named runs. @param runs in rising order, the first of which begins at 0 */
function runsIn(
  runs: readonly NamedRun[] | undefined,
  start: number,
  count: number,
): Pick<Piece, 'start' | 'count' | 'run'>[] {
  if (!runs) return [{ start, count, run: undefined }];
  const found: Pick<Piece, 'start' | 'count' | 'run'>[] = [];
  for (let i = lastAtOrBefore(runs, start); i < runs.length && runs[i].start < start + count; i++) {
    const from = Math.max(runs[i].start, start);
    const to = Math.min(runs[i + 1]?.start ?? Infinity, start + count);
    if (to > from) found.push({ start: from, count: to - from, run: runs[i] });
  }
  return found;
}

/** The index of the last run that begins at or before a corner. */
function lastAtOrBefore(runs: readonly NamedRun[], corner: number): number {
  let low = 0;
  for (let high = runs.length; high - low > 1; ) {
    const middle = (low + high) >> 1;
    if (runs[middle].start <= corner) low = middle;
    else high = middle;
  }
  return low;
}

/** The named parts of a merged scene; undefined if there are fewer than two. */
function namedParts(placed: readonly Part[], vertexCount: number, root: Object3D): MeshParts | undefined {
  const drawn = placed.filter(({ pieces }) => pieces.length > 0);
  const meshes = [...new Set(drawn.map(({ mesh }) => mesh))];
  const names = meshNames(root, meshes);
  const ofMeshes = new Map(meshes.map((mesh, i) => [mesh, i]));
  const keyOf = (mesh: Mesh, { run, material }: Piece): string | number => {
    if (run) return run.part;
    return meshes.length === 1 ? (material?.uuid ?? '') : ofMeshes.get(mesh)!;
  };
  const nameOf = (mesh: Mesh, { run, material }: Piece): string => {
    if (run) return run.name;
    return meshes.length === 1 ? materialName(material) : names[ofMeshes.get(mesh)!];
  };
  const indices = new Map<string, number>();
  const found: string[] = [];
  const ofVertices = new Uint32Array(vertexCount);
  for (const { mesh, pieces, isUnshared, firstVertex, vertexCount: count } of drawn) {
    for (const piece of pieces) {
      const key = `${ofMeshes.get(mesh)} ${keyOf(mesh, piece)}`;
      let index = indices.get(key);
      if (index === undefined) {
        index = found.push(nameOf(mesh, piece)) - 1;
        indices.set(key, index);
      }
      const first = firstVertex + (isUnshared ? piece.first : 0);
      ofVertices.fill(index, first, first + (isUnshared ? piece.count : count));
    }
  }
  return found.length > 1 ? { names: partNames(found), ofVertices } : undefined;
}

function pictureOf(
  geometry: BufferGeometry,
  material: Material | undefined,
  pictures: WantedPicture[] | undefined,
): number {
  const texture = pictured(material);
  // Glass is drawn by its outlines, without its picture.
  if (!pictures || !texture || material!.transparent || !geometry.getAttribute(uvName(texture))) return -1;
  const cutOut = material!.alphaTest;
  const mask = cutOut > 0 ? maskOf(material) : undefined;
  const isBlended = cutOut > 0 && material!.userData.isBlended === true;
  const mayBeWhole = cutOut > 0 && material!.userData.mayBeWhole === true;
  const wanted = {
    texture,
    cutOut,
    ...(mask && { mask }),
    ...(isBlended && { isBlended }),
    ...(mayBeWhole && { mayBeWhole }),
  };
  const key = pictureKey(wanted);
  const known = pictures.findIndex((picture) => pictureKey(picture) === key);
  return known === -1 ? pictures.push(wanted) - 1 : known;
}

/** A key for pictures that can share a texture. Offset and scale are written into texture coordinates. */
function pictureKey({ texture, mask, cutOut, isBlended, mayBeWhole }: WantedPicture): string {
  const { flipY, wrapS, wrapT } = texture;
  const { isInverted } = mask?.userData ?? {};
  const urls = [linkOf(texture)?.url, mask && linkOf(mask)?.url];
  return [...urls, isInverted, flipY, wrapS, wrapT, cutOut, isBlended, mayBeWhole].join();
}

/** The texture of a material: its colour map or, without one, its alpha map. */
const pictured = (material: Material | undefined): Texture | undefined => mapOf(material) ?? maskOf(material);

const linkOf = ({ image }: Texture): Partial<PictureLink> | null => image as Partial<PictureLink> | null;

/** The colour map of a material, if it is linked. */
const mapOf = (material: Material | undefined): Texture | undefined => linked((material as Maps | undefined)?.map);

/** The alpha map of a material, if it is a separate picture. */
function maskOf(material: Material | undefined): Texture | undefined {
  const { map, alphaMap } = (material ?? {}) as Maps;
  const mask = linked(alphaMap);
  const isOther = mask && (mask.userData.isInverted || linkOf(mask)?.url !== (map && linkOf(map)?.url));
  return isOther ? mask : undefined;
}

type Maps = { map?: Texture | null; alphaMap?: Texture | null };

const linked = (texture: Texture | null | undefined): Texture | undefined =>
  texture?.isTexture && linkOf(texture)?.url ? texture : undefined;

const uvName = ({ channel }: Texture): string => (channel === 0 ? 'uv' : `uv${channel}`);

function isDeformed(mesh: Mesh): boolean {
  return 'isSkinnedMesh' in mesh || (mesh.morphTargetInfluences?.some((influence) => influence !== 0) ?? false);
}

/** Normals of skinned or morphed meshes are not deformed here, and are computed from the surface later. */
function hasUsableNormals(mesh: Mesh): boolean {
  return mesh.geometry.getAttribute('normal') !== undefined && !isDeformed(mesh);
}

/** The colour of a piece. Black becomes white under a picture: some programs write it, and it would hide the picture. NaN becomes 1. */
function pieceColor({ material, picture }: Piece): [number, number, number] {
  const color = material && reflectedColor(material);
  if (!color || (picture !== -1 && color.r + color.g + color.b === 0)) return [1, 1, 1];
  return color.toArray().map((value) => (Number.isFinite(value) ? value : 1)) as [number, number, number];
}

function vertexColors({ geometry }: Mesh): ReturnType<BufferGeometry['getAttribute']> | undefined {
  const color = geometry.getAttribute('color');
  return color?.count === geometry.getAttribute('position').count ? color : undefined;
}

const isColored = (mesh: Mesh, piece: Piece): boolean =>
  vertexColors(mesh) !== undefined || pieceColor(piece).some((value) => value !== 1);

/** Calls back with every written vertex and its index in the geometry. */
function forEachVertex({ mesh, pieces, isUnshared, firstVertex, vertexCount }: Part, write: VertexWriter): void {
  if (!isUnshared) {
    for (let i = 0; i < vertexCount; i++) write(firstVertex + i, i, pieces[0]);
    return;
  }
  const { index } = mesh.geometry;
  for (const piece of pieces) {
    for (let corner = 0; corner < piece.count; corner++) {
      const at = piece.start + corner;
      write(firstVertex + piece.first + corner, index ? index.getX(at) : at, piece);
    }
  }
}

type VertexWriter = (to: number, from: number, piece: Piece | undefined) => void;

function writeVertices(part: Part, positions: Float32Array, normals: Float32Array | null): void {
  const { mesh, matrix } = part;
  const { position, normal } = mesh.geometry.attributes;
  const normalMatrix = new Matrix3().getNormalMatrix(matrix);
  const deformed = isDeformed(mesh);
  const isNormalUsed = normals !== null && hasUsableNormals(mesh);
  const vector = new Vector3();
  forEachVertex(part, (to, from) => {
    // An index out of range gives NaN, and its triangle is removed later.
    if (deformed && from < position.count) mesh.getVertexPosition(from, vector);
    else vector.fromBufferAttribute(position, from);
    vector.applyMatrix4(matrix).toArray(positions, 3 * to);
    if (isNormalUsed)
      vector
        .fromBufferAttribute(normal, from)
        .applyMatrix3(normalMatrix)
        .normalize()
        .toArray(normals, 3 * to);
  });
}

function writeColors(part: Part, colors: Float32Array): void {
  const attribute = vertexColors(part.mesh);
  const ofPiece = new Map(part.pieces.map((piece) => [piece, pieceColor(piece)]));
  forEachVertex(part, (to, from, piece) => {
    const [r, g, b] = (piece && ofPiece.get(piece)) ?? [1, 1, 1];
    colors[3 * to] = r * (attribute?.getX(from) ?? 1);
    colors[3 * to + 1] = g * (attribute?.getY(from) ?? 1);
    colors[3 * to + 2] = b * (attribute?.getZ(from) ?? 1);
  });
}

function writeUvs(part: Part, uvs: Float32Array): void {
  const { geometry } = part.mesh;
  const place = new Vector2();
  for (const { material } of part.pieces) pictured(material)?.updateMatrix();
  forEachVertex(part, (to, from, piece) => {
    const texture = pictured(piece?.material);
    if (!texture || piece?.picture === -1) return;
    place.fromBufferAttribute(geometry.getAttribute(uvName(texture)) as never, from);
    place.applyMatrix3(texture.matrix).toArray(uvs, 2 * to);
  });
}

function drawnCorners(geometry: BufferGeometry): { start: number; count: number } {
  const available = geometry.index?.count ?? geometry.getAttribute('position').count;
  const start = Math.min(geometry.drawRange.start, available);
  const count = Math.min(geometry.drawRange.count, available - start);
  return { start, count: count - (count % 3) };
}

/**
 * Copies the indices. A mirroring matrix reverses the winding, which is corrected; of one-sided surfaces as in three.js, where instances
 * have the winding of their mesh.
 */
function writeIndices(
  { mesh, matrix, isUnshared, firstVertex }: Part,
  { start, count, first, isOneSided }: Piece,
  indices: Uint32Array,
  at: number,
): number {
  const { geometry } = mesh;
  const order = (isOneSided ? mesh.matrixWorld : matrix).determinant() < 0 ? [0, 2, 1] : [0, 1, 2];
  const vertexCount = geometry.getAttribute('position').count;
  let to = at;
  for (let corner = 0; corner < count; corner += 3) {
    for (const k of order) {
      if (isUnshared) {
        indices[to++] = firstVertex + first + corner + k;
        continue;
      }
      const vertex = geometry.index ? geometry.index.getX(start + corner + k) : start + corner + k;
      // An index out of range must not refer to a vertex of the next mesh, so it stays out of range in the merged mesh.
      indices[to++] = vertex < vertexCount ? firstVertex + vertex : 0xffffffff;
    }
  }
  return to;
}

/** The maximum size of a model, and the inverse of the minimum, in single precision. */
const MAX_SIZE = 1e20;

/**
 * A matrix that moves meshes to the origin and scales them to a size of 1; undefined if not needed. Without it, tiny models would collapse
 * to a point, and distant ones would be rounded visibly.
 */
function nearOrigin(placed: readonly { mesh: Mesh; matrix: Matrix4 }[]): Matrix4 | undefined {
  const low = new Vector3().setScalar(Infinity);
  const high = new Vector3().setScalar(-Infinity);
  const bounds = new Map<BufferGeometry, Vector3[]>();
  const corner = new Vector3();
  for (const { mesh, matrix } of placed) {
    const { geometry } = mesh;
    if (!bounds.has(geometry)) bounds.set(geometry, cornersOf(geometry));
    for (const place of bounds.get(geometry)!) {
      corner.copy(place).applyMatrix4(matrix);
      low.min(corner);
      high.max(corner);
    }
  }
  const centre = low.clone().lerp(high, 0.5);
  const size = high.distanceTo(low);
  const distance = centre.length();
  if (!(size > 0 && size + distance < Infinity)) return undefined;
  if (size < MAX_SIZE && size > 1 / MAX_SIZE && distance < FAR * size) return undefined;
  return new Matrix4().makeScale(1 / size, 1 / size, 1 / size).multiply(new Matrix4().makeTranslation(centre.negate()));
}

/** The corners of the bounding box of all drawn, finite vertices; empty if there are none. */
function cornersOf({ index, attributes: { position } }: BufferGeometry): Vector3[] {
  const low = new Vector3().setScalar(Infinity);
  const high = new Vector3().setScalar(-Infinity);
  const point = new Vector3();
  for (let i = 0; i < (index ?? position).count; i++) {
    point.fromBufferAttribute(position, index ? index.getX(i) : i);
    const sum = point.x + point.y + point.z;
    if (sum - sum !== 0) continue;
    low.min(point);
    high.max(point);
  }
  if (low.x > high.x) return [];
  return Array.from(
    { length: 8 },
    (_, i) => new Vector3(i & 1 ? low.x : high.x, i & 2 ? low.y : high.y, i & 4 ? low.z : high.z),
  );
}
