import {
  type AnimationClip,
  Box3,
  BufferAttribute,
  Group,
  type InstancedMesh,
  type InterleavedBufferAttribute,
  MathUtils,
  type Mesh,
  type MeshStandardMaterial,
  Object3D,
  Vector3,
} from 'three';
import { applyHatching } from 'three-hatching';
import { counted } from '../files/common/ModelError.js';
import { partNames } from '../files/common/partNames.js';
import { Slices } from '../files/common/Slices.js';
import type { ModelScene } from '../files/gltf/parseGltf.js';
import { findUpAxis, type UsualUp } from '../files/mesh/findUpAxis.js';
import { measureExtent } from '../files/mesh/fitModel.js';
import { checkTriangleCount, thinNote } from '../files/mesh/PlainMesh.js';
import { meshNames } from '../files/scenes/meshNames.js';
import { repairScene } from '../files/scenes/repairGeometry.js';
import { resolveAlpha } from '../files/scenes/resolveAlpha.js';
import { castFronts, openMeshes } from './castFronts.js';
import { HatchedModel } from './HatchedModel.js';
import { type ChooseHidden, SceneParts } from './ModelParts.js';
import { Motion } from './Motion.js';
import { freeGraphics } from './materials.js';
import { carryingBox, drawnMeshes, drawnVertices, meshesOf, placements, standingBox } from './meshes.js';
import { statisticsOf } from './statistics.js';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/**
 * Whether three's WebGPURenderer widens an attribute in place to 32-bit integers when it uploads it, which WebGLRenderer then cannot draw.
 * Instanced ones are not used by the page's materials.
 */
const isRewritten = (attribute: Attribute): boolean =>
  !attribute.normalized && attribute.array.BYTES_PER_ELEMENT < 4 && !('isInstancedBufferAttribute' in attribute);

/** Converts narrow integer attributes, such as bone indices, to floats, so that both renderers can draw them. */
export function widenIntegers(root: Object3D): void {
  // Meshes of a file often share attributes.
  const floats = new Map<Attribute, BufferAttribute>();
  for (const { geometry } of meshesOf(root)) {
    for (const [name, attribute] of Object.entries(geometry.attributes)) {
      if (!isRewritten(attribute)) continue;
      const wide = floats.get(attribute) ?? asFloats(attribute);
      floats.set(attribute, wide);
      geometry.setAttribute(name, wide);
    }
  }
}

function asFloats(attribute: Attribute): BufferAttribute {
  const { count, itemSize, name } = attribute;
  const values = new Float32Array(count * itemSize);
  for (let i = 0; i < values.length; i++) values[i] = attribute.getComponent(Math.floor(i / itemSize), i % itemSize);
  const floats = new BufferAttribute(values, itemSize);
  floats.name = name;
  return floats;
}

/** The maximum numbers of poses and vertices for the bounds of a clip. A skinned vertex takes about a microsecond. */
const MAX_POSES = 8;
const MAX_POINTS = 20_000;

/**
 * Makes a hatched model of a scene with its textures, skins, morph targets and clips. Lines, points and lights are hidden, because the page
 * draws no lines and has its own lights.
 *
 * @param options `usual` is the common up axis of the format; undefined if the file states it. `hidden` chooses the parts that are hidden. The
 *   shadows of what is read from a file agree with the sides that are seen
 * @returns the model, and notes for the caption about meshes and clips that were left out, for instance because of NaN values
 * @throws ModelError with one sentence for the user
 */
export async function modelOfScene(
  { root, animations }: ModelScene,
  {
    usual,
    hidden,
    isOfFile = false,
    ...options
  }: {
    isOfFile?: boolean;
    hidden?: ChooseHidden | undefined;
    usual?: UsualUp | undefined;
    adjacency?: boolean;
    signal: AbortSignal;
    onProgress: (progress: number) => void;
    onGeometry: (done: number, total: number) => void;
  },
): Promise<{ model: HatchedModel; notes: string[] }> {
  const slices = new Slices(options.signal);
  const usable = animations.filter(isUsable);
  hideAllButMeshes(root);
  repairScene(root);
  await slices.next();
  const alphaNotes = resolveAlpha(root);
  removeUnseen(root);
  leaveNormalsOpen(root);
  widenIntegers(root);
  await slices.next();
  const motion = new Motion(root, usable);
  const holder = new Group().add(root);
  await slices.next();
  const { framedPoints, standing } = fitScene(holder, motion);
  await slices.next();
  const { points, share } = someTriangles(root);
  const stands = usual && findUpAxis(points, null, usual)?.up;
  await slices.next();

  const casting = isOfFile ? await openMeshes(root, slices) : [];
  // One tile per world unit, which the settings scale.
  const hatched = await applyHatching(root, { tonalArtMap: null, tilesPerWorldUnit: 1, outlines: true, ...options });
  castFronts(casting);
  // From here on, cancelling disposes of the model, which frees everything.
  const ending = new Slices();
  const damaged = hatched.skipped.filter(({ error }) => error);
  for (const { mesh } of damaged) mesh.visible = false;
  for (const mesh of meshesOf(root)) {
    // Its bounding sphere holds for the rest pose only.
    if ('isSkinnedMesh' in mesh || mesh.morphTargetInfluences) mesh.frustumCulled = false;
  }
  const statistics = statisticsOf(root);
  await ending.next();
  const model = new HatchedModel(
    holder,
    standing,
    framedPoints,
    stands,
    statistics,
    motion.canMove ? motion : undefined,
    hatched.materials,
    hatched.outlines,
    () => {
      motion.dispose();
      hatched.dispose();
      // The source materials have been restored, and with them all textures of the file.
      freeGraphics(root);
    },
  );
  const meshes = meshesOf(root).filter(({ visible }) => visible);
  if (meshes.length > 1) {
    model.parts = new SceneParts(partNames(meshNames(root, meshes)), meshes);
    model.parts.hide?.(hidden?.(model.parts.names) ?? []);
  }
  const notes = [...alphaNotes, ...thinNote(points, null, share)];
  return { model, notes: [...notes, ...leftOut(damaged.length, animations.length - usable.length)] };
}

function leftOut(parts: number, clips: number): string[] {
  return [counted(parts, 'damaged part', 'left out'), counted(clips, 'damaged clip', 'left out')].filter(Boolean);
}

const isUsable = ({ tracks, duration }: AnimationClip): boolean =>
  duration < Infinity &&
  tracks.every(({ times, values }) => times.every(Number.isFinite) && values.every(Number.isFinite));

function hideAllButMeshes(root: Object3D): void {
  root.traverse((object) => {
    if ('isLight' in object || 'isLine' in object || 'isPoints' in object) object.visible = false;
  });
}

/**
 * Removes the flat normals that three's loader makes up for meshes without normals. They are computed later, with creases kept, as for
 * other formats.
 */
function leaveNormalsOpen(root: Object3D): void {
  for (const { geometry, material } of meshesOf(root)) {
    if (geometry.hasAttribute('normal')) continue;
    for (const one of [material].flat()) if (one) (one as Partial<MeshStandardMaterial>).flatShading = false;
  }
}

/** Replaces invisible meshes by plain objects, which keep their children. */
function removeUnseen(root: Object3D): void {
  for (const mesh of meshesOf(root)) {
    if (!mesh.parent || [mesh.material].flat().some((material) => material?.visible)) continue;
    const plain = Object3D.prototype.copy.call(new Object3D(), mesh, false);
    plain.uuid = mesh.uuid;
    // Tracks of a clip go on to set them.
    Object.assign(plain, { morphTargetInfluences: mesh.morphTargetInfluences });
    mesh.parent.add(plain);
    mesh.removeFromParent();
    for (const child of [...mesh.children]) plain.add(child);
  }
}

/**
 * Centres the content of `holder` and scales it so that the farthest vertex in all sampled poses of the clip is at distance 1.
 *
 * @returns points of its outline in these poses, as xyz, and the box of the parts that stand on the ground
 */
function fitScene(holder: Group, motion: Motion): { framedPoints: Float32Array; standing: Box3 } {
  const vertices = countVertices(holder);
  const poses = motion.duration > 0 ? MathUtils.clamp(Math.floor(MAX_POINTS / vertices), 1, MAX_POSES) : 1;
  const step = Math.ceil((vertices * poses) / MAX_POINTS);
  const points: number[] = [];
  const boxes: Box3[] = [];
  const parts = drawnPartsOf(holder);
  for (let i = 0; i < poses; i++) {
    motion.time = (i / poses) * motion.duration;
    holder.updateMatrixWorld(true);
    addPoints(parts, step, points);
    boxes.push(carryingBox(holder));
  }
  motion.time = 0;
  const { centre, radius } = measureExtent(points);
  holder.scale.setScalar(1 / radius);
  holder.position.set(...centre).divideScalar(-radius);
  holder.updateMatrixWorld(true);
  const framedPoints = new Float32Array(points.length);
  const point = new Vector3();
  for (let i = 0; i < points.length; i += 3)
    point.fromArray(points, i).applyMatrix4(holder.matrixWorld).toArray(framedPoints, i);
  const standing = standingBox(boxes).applyMatrix4(holder.matrixWorld);
  return { framedPoints, standing: standing.isEmpty() ? new Box3().setFromArray(framedPoints) : standing };
}

/** An even sample of a scene's triangles, as xyz of their corners, and its share of all triangles. */
function someTriangles(root: Object3D): { points: number[]; share: number } {
  const parts = meshesOf(root).map((mesh) => {
    const { index, attributes } = mesh.geometry;
    return { mesh, index, corners: index?.count ?? attributes.position?.count ?? 0, matrices: placements(mesh) };
  });
  const all = parts.reduce((sum, { corners, matrices }) => sum + corners * matrices.length, 0);
  const step = 3 * Math.ceil(all / MAX_POINTS);
  const points: number[] = [];
  const point = new Vector3();
  for (const { mesh, index, corners, matrices } of parts) {
    for (const matrix of matrices) {
      for (let corner = 0; corner + 2 < corners; corner += step) {
        const triangle = [corner, corner + 1, corner + 2].flatMap((i) =>
          mesh
            .getVertexPosition(index ? index.getX(i) : i, point)
            .applyMatrix4(matrix)
            .toArray(),
        );
        if (triangle.every(Number.isFinite)) points.push(...triangle);
      }
    }
  }
  return { points, share: 3 / step };
}

/** A mesh, and flags of its visible vertices. */
interface DrawnPart {
  mesh: Mesh;
  drawn: Uint8Array;
}

/** The visible parts of a scene, or all parts if none is visible. */
function drawnPartsOf(holder: Group): DrawnPart[] {
  const parts = drawnMeshes(holder).map((mesh) => ({ mesh, drawn: drawnVertices(mesh) }));
  if (parts.some(({ drawn }) => drawn.includes(1))) return parts;
  return meshesOf(holder).map((mesh) => ({ mesh, drawn: drawnVertices(mesh).fill(1) }));
}

/** Appends the world positions of every `step`th visible vertex in the current pose. */
function addPoints(parts: readonly DrawnPart[], step: number, points: number[]): void {
  const point = new Vector3();
  for (const { mesh, drawn } of parts) {
    for (const matrix of placements(mesh)) {
      for (let i = 0; i < drawn.length; i += step) {
        if (drawn[i] === 0) continue;
        mesh.getVertexPosition(i, point).applyMatrix4(matrix);
        // A mesh with NaN coordinates is left out later.
        if (Number.isFinite(point.x + point.y + point.z)) points.push(point.x, point.y, point.z);
      }
    }
  }
}

/** @throws ModelError if there is nothing to draw, or too much */
function countVertices(holder: Group): number {
  let vertices = 0;
  let triangles = 0;
  for (const mesh of meshesOf(holder)) {
    const { geometry } = mesh;
    const count = geometry.getAttribute('position')?.count ?? 0;
    const times = 'isInstancedMesh' in mesh ? (mesh as InstancedMesh).count : 1;
    vertices += count * times;
    triangles += ((geometry.index?.count ?? count) / 3) * times;
  }
  checkTriangleCount(vertices > 0 ? triangles : 0);
  return vertices;
}
