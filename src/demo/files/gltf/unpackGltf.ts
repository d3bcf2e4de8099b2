import { counted } from '../common/counted.js';
import { ModelError } from '../common/ModelError.js';
import { checkTriangleCount } from '../mesh/checkTriangleCount.js';
import type { ChosenScene } from './chooseScene.js';
import { dracoSource } from './dracoSource.js';
import { fitWeights, GltfGeometry, type PlainGltfMesh } from './GltfGeometry.js';
import type { GltfValues } from './GltfValues.js';
import { GltfWriter } from './GltfWriter.js';
import { writeAnimations } from './gltfAnimations.js';
import type { GltfDocument, GltfNode } from './gltfDocument.js';

/** A glTF document with one scene, whose values were all read and checked. */
export interface PlainGltf {
  /** Without its materials, textures and samplers. */
  json: {
    asset: { version: '2.0' };
    extensionsUsed: string[];
    scene: 0;
    scenes: object[];
    nodes: object[];
    meshes: object[];
    skins: object[];
    animations: object[];
    accessors: object[];
    bufferViews: object[];
  };
  /** By the index of their buffer view. */
  arrays: ArrayBuffer[];
  /** Of what is drawn; instances count as often as they are drawn. */
  triangles: number;
  vertices: number;
  draws: number;
  /** Whether there is anything that moves: clips, skins or shapes. */
  moves: boolean;
  /** Triangles that were left out. */
  broken: number;
  /** What to say about the rest that was left out. */
  notes: string[];
  /** What only those want to know who look closer. */
  details: string[];
}

const INSTANCED = 'EXT_mesh_gpu_instancing';
const INSTANCE_SIZES: Record<string, number> = { TRANSLATION: 3, ROTATION: 4, SCALE: 3, _COLOR_0: 3 };
const NO_TRIANGLES = 'holds no triangles; only surfaces can be hatched, not points or lines';

/**
 * Unpacks the chosen part of a document: every accessor, part and track in use is read and checked, and written anew without
 * packing. What a model can do without is left out if it is damaged.
 *
 * @throws ModelError if its data is not all there, or there are no triangles, or too many
 */
export async function unpackGltf(
  document: GltfDocument,
  chosen: ChosenScene,
  values: GltfValues,
  fileName: string,
): Promise<PlainGltf> {
  const writer = new GltfWriter();
  const geometry = new GltfGeometry(values, writer, dracoSource(document, values, fileName));
  const skins = document.skins.map((skin) => skin && writeSkin(skin, values, writer));
  const visible = new Set(chosen.visible);
  const meshes: object[] = [];
  const variants = new Map<string, Promise<(PlainGltfMesh & { index: number }) | undefined>>();
  const sums = { triangles: 0, vertices: 0, draws: 0 };
  const shapes: number[] = [];
  let isSkinned = false;
  let skeletons = 0;
  let instancesLeftOut = 0;

  /** A mesh with a skeleton is another one than without. */
  const meshOf = (mesh: number, joints: number): Promise<(PlainGltfMesh & { index: number }) | undefined> => {
    const key = `${mesh} ${joints}`;
    let variant = variants.get(key);
    if (!variant) {
      variant = geometry
        .writeMesh(document.meshes[mesh], joints)
        .then((plain) => plain && { ...plain, index: meshes.push(plain.json) - 1 });
      variants.set(key, variant);
    }
    return variant;
  };

  const nodes: object[] = [];
  for (const [i, node] of document.nodes.entries()) {
    const { name, children, matrix, translation, rotation, scale } = node;
    const plain: Record<string, unknown> = { name, matrix, translation, rotation, scale };
    if (children?.length) plain.children = children;
    nodes.push(plain);
    if (node.mesh === undefined || !visible.has(i)) continue;
    const places = instanceAccessors(node, values);
    const skin = node.skin === undefined || places.length > 0 ? undefined : skins[node.skin];
    const mesh = await meshOf(node.mesh, skin?.joints.length ?? 0);
    if (!mesh) continue;
    const count = places.length > 0 ? Math.min(...places.map(([, accessor]) => values.countOf(accessor))) : 1;
    checkTriangleCount(Math.max(1, sums.triangles + mesh.triangles * count));
    const instances = places.length > 0 ? readInstances(places, count, values) : undefined;
    instancesLeftOut += instances?.leftOut ?? 0;
    if (instances?.count === 0) continue;
    plain.mesh = mesh.index;
    shapes[i] = mesh.shapes;
    if (mesh.shapes > 0 && node.weights) plain.weights = fitWeights(node.weights, mesh.shapes);
    if (mesh.isSkinned) plain.skin = node.skin;
    else if (node.skin !== undefined) skeletons++;
    isSkinned ||= mesh.isSkinned;
    if (instances) {
      const attributes = Object.fromEntries(
        instances.attributes.map(([key, array]) => [key, writer.add(array, INSTANCE_SIZES[key])]),
      );
      plain.extensions = { [INSTANCED]: { attributes } };
    }
    sums.triangles += mesh.triangles * (instances?.count ?? 1);
    sums.vertices += mesh.vertices * (instances?.count ?? 1);
    sums.draws += mesh.json.primitives.length;
  }
  if (sums.triangles === 0) throw new ModelError(`${fileName} ${NO_TRIANGLES}.`);

  const inScene = belowRoots(document, chosen.roots);
  const { animations, leftOut: tracks } = writeAnimations(
    document,
    values,
    writer,
    inScene,
    (node) => shapes[node] ?? 0,
  );
  const { leftOut } = geometry;
  return {
    json: {
      asset: { version: '2.0' },
      extensionsUsed: [INSTANCED, 'KHR_texture_transform', 'KHR_materials_emissive_strength'],
      scene: 0,
      scenes: [{ name: chosen.name, nodes: chosen.roots }],
      nodes,
      meshes,
      // Skins keep their places, for the nodes that refer to them.
      skins: skins.map((skin) => skin ?? { joints: [] }),
      animations,
      accessors: writer.accessors,
      bufferViews: writer.arrays.map(({ byteLength }) => ({ buffer: 0, byteLength })),
    },
    arrays: writer.arrays,
    ...sums,
    moves: isSkinned || animations.length > 0 || shapes.some((count) => count > 0),
    broken: leftOut.triangles,
    notes: [
      counted(leftOut.shapes, 'shape', 'left out: too many'),
      counted(tracks, 'damaged animation track', 'left out'),
      counted(skeletons, 'damaged skeleton', 'left out'),
      counted(instancesLeftOut, 'damaged instance', 'left out'),
      leftOut.lines > 0 ? 'points and lines left out' : '',
    ].filter(Boolean),
    details: leftOut.attributes > 0 ? ['values that do not fit its vertices left out'] : [],
  };
}

/** A skin with a matrix for each of its joints, or undefined. */
function writeSkin(
  { joints, inverseBindMatrices }: NonNullable<GltfDocument['skins'][number]>,
  values: GltfValues,
  writer: GltfWriter,
): { joints: number[]; inverseBindMatrices?: number } | undefined {
  if (joints.length === 0) return undefined;
  if (inverseBindMatrices === undefined) return { joints };
  if (values.sizeOf(inverseBindMatrices) !== 16) return undefined;
  const matrices = values.tryFloats(inverseBindMatrices);
  if (!matrices || matrices.length < 16 * joints.length || !matrices.every(Number.isFinite)) return undefined;
  return { joints, inverseBindMatrices: writer.add(matrices, 16) };
}

interface Instances {
  count: number;
  attributes: [name: string, values: Float32Array][];
  leftOut: number;
}

/** The accessors of what places the instances of a node. None if it has no instances. */
function instanceAccessors({ extensions }: GltfNode, values: GltfValues): [name: string, accessor: number][] {
  return Object.entries(extensions?.[INSTANCED]?.attributes ?? {}).filter(
    ([name, accessor]) => INSTANCE_SIZES[name] === values.sizeOf(accessor),
  );
}

/** Reads so many instances, without those whose values are not numbers. */
function readInstances(accessors: [name: string, accessor: number][], total: number, values: GltfValues): Instances {
  const read = accessors.map(([name, accessor]) => ({
    name,
    size: INSTANCE_SIZES[name],
    array: values.floatsOf(accessor),
  }));
  const isBad = new Uint8Array(total);
  for (const { size, array } of read) {
    for (let i = 0; i < size * total; i++) if (!Number.isFinite(array[i])) isBad[Math.floor(i / size)] = 1;
  }
  const kept = [...isBad.keys()].filter((instance) => isBad[instance] === 0);
  const pick = (array: Float32Array, size: number): Float32Array => {
    if (kept.length === total && array.length === size * total) return array;
    const picked = new Float32Array(size * kept.length);
    for (const [to, from] of kept.entries()) picked.set(array.subarray(size * from, size * (from + 1)), size * to);
    return picked;
  };
  return {
    count: kept.length,
    attributes: read.map(({ name, size, array }) => [name, pick(array, size)]),
    leftOut: total - kept.length,
  };
}

function belowRoots({ nodes }: GltfDocument, roots: readonly number[]): Set<number> {
  const found = new Set<number>();
  const pending = [...roots];
  for (let node = pending.pop(); node !== undefined; node = pending.pop()) {
    found.add(node);
    for (const child of nodes[node].children ?? []) pending.push(child);
  }
  return found;
}
