import type { DecoderModule } from 'draco3d';
import { counted, ModelError } from '../common/ModelError.js';
import type { Surroundings } from '../common/Surroundings.js';
import type { ChosenScene } from './chooseScene.js';
import { type DracoAttribute, type DracoPart, decodeDraco } from './decodeDraco.js';
import { type DracoSource, GltfGeometry } from './GltfGeometry.js';
import { GltfNodes, INSTANCING, type PlainSkin } from './GltfNodes.js';
import { type AccessorValues, type GltfValues, GltfWriter } from './GltfValues.js';
import type { GltfAnimationSampler, GltfChannel, GltfDocument } from './gltfDocument.js';

/** A glTF document with one scene, whose values have all been read and checked. */
export interface PlainGltf {
  /** Without materials, textures and samplers. */
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
  /** The arrays, by buffer view index. */
  arrays: ArrayBuffer[];
  /** Counts of what is drawn, with each instance counted. */
  triangles: number;
  vertices: number;
  draws: number;
  /** Whether anything moves, by clips, skeletons or morph targets. */
  moves: boolean;
  /** The number of triangles left out. */
  broken: number;
  /** Notes for the caption on what else was left out. */
  notes: string[];
  /** Details for the longer text that opens on request. */
  details: string[];
}

const NO_TRIANGLES = 'holds no triangles; only surfaces can be hatched, not points or lines';

/**
 * Unpacks the chosen part of a document: reads, checks and rewrites every accessor, primitive and track in use without compression. Damaged
 * optional parts are left out.
 *
 * @throws ModelError if data is missing, or there are no triangles, or too many
 */
export async function unpackGltf(
  document: GltfDocument,
  chosen: ChosenScene,
  values: AccessorValues,
  fileName: string,
  draco: DracoSource,
): Promise<PlainGltf> {
  const writer = new GltfWriter();
  const geometry = new GltfGeometry(values, writer, draco);
  const skins = document.skins.map((skin) => skin && writeSkin(skin, values, writer));
  const visible = new Set(chosen.visible);
  const written = new GltfNodes(document, values, geometry, skins, writer);
  for (const [i, node] of document.nodes.entries()) await written.write(node, visible.has(i));
  const { nodes, meshes, shapes, sums } = written;
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
      extensionsUsed: [INSTANCING, 'KHR_texture_transform', 'KHR_materials_emissive_strength'],
      scene: 0,
      scenes: [{ name: chosen.name, nodes: chosen.roots }],
      nodes,
      meshes,
      // Damaged skins stay as empty ones, since nodes refer to skins by index.
      skins: skins.map((skin) => skin ?? { joints: [] }),
      animations,
      accessors: writer.accessors,
      bufferViews: writer.arrays.map(({ byteLength }) => ({ buffer: 0, byteLength })),
    },
    arrays: writer.arrays,
    ...sums,
    moves: written.isSkinned || animations.length > 0 || shapes.some((count) => count > 0),
    broken: leftOut.triangles,
    notes: [
      counted(leftOut.shapes, 'shape', 'left out: too many'),
      counted(tracks, 'damaged animation track', 'left out'),
      counted(written.leftOut.skeletons, 'damaged skeleton', 'left out'),
      counted(written.leftOut.instances, 'damaged instance', 'left out'),
      leftOut.lines > 0 ? 'points and lines left out' : '',
    ].filter(Boolean),
    details: leftOut.attributes > 0 ? ['values that do not fit its vertices left out'] : [],
  };
}

/** Writes a skin with one matrix per joint; undefined if it is damaged. */
function writeSkin(
  { joints, inverseBindMatrices }: NonNullable<GltfDocument['skins'][number]>,
  values: AccessorValues,
  writer: GltfWriter,
): PlainSkin {
  if (joints.length === 0) return undefined;
  if (inverseBindMatrices === undefined) return { joints };
  if (values.sizeOf(inverseBindMatrices) !== 16) return undefined;
  const matrices = values.tryFloats(inverseBindMatrices);
  if (!matrices || matrices.length < 16 * joints.length || !matrices.every(Number.isFinite)) return undefined;
  return { joints, inverseBindMatrices: writer.add(matrices, 16) };
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

/** Returns the decoder of Draco-compressed primitives, which is loaded when the first needs it. */
export function dracoSource(
  document: GltfDocument,
  values: GltfValues,
  fileName: string,
  loadDraco: Surroundings['loadDraco'],
): DracoSource {
  let loaded: Promise<DecoderModule> | undefined;
  return async ({ bufferView, attributes }, primitive) => {
    const wanted = new Map<string, DracoAttribute>();
    for (const [name, id] of Object.entries(attributes)) {
      const accessor = primitive.attributes[name];
      if (accessor !== undefined) wanted.set(name, { id, componentType: document.accessors[accessor].componentType });
    }
    const bytes = values.viewOf(bufferView);
    loaded ??= loadDraco();
    const draco = await loaded.catch(() => {
      throw new ModelError(
        `${fileName} is packed with Draco, whose decoder could not be fetched. Look after the connection, and open it again.`,
      );
    });
    let part: DracoPart;
    try {
      part = decodeDraco(draco, bytes, wanted);
    } catch (error) {
      if (error instanceof ModelError) throw error;
      throw new ModelError(`${fileName} is damaged: a part packed with Draco cannot be unpacked.`);
    }
    for (const [name, attribute] of part.attributes) values.normalize(primitive.attributes[name], attribute.values);
    return part;
  };
}

const VALUES_PER_KEY = { translation: 3, rotation: 4, scale: 3 } as const;
/** Values per key of a cubic spline: the value and two tangents. */
const SPLINE_VALUES = 3;

/**
 * Writes the animations of a document, without tracks that cannot be played: three's mixer would loop forever over keys with the wrong
 * number of values.
 *
 * @param inScene the nodes that are shown; tracks of others belong to other scenes
 * @param shapesOf the number of morph targets of a node's mesh
 * @returns the animations, and the number of tracks left out
 */
function writeAnimations(
  { animations }: GltfDocument,
  values: AccessorValues,
  writer: GltfWriter,
  inScene: ReadonlySet<number>,
  shapesOf: (node: number) => number,
): { animations: object[]; leftOut: number } {
  let leftOut = 0;
  const written: object[] = [];
  for (const animation of animations) {
    if (!animation) {
      leftOut++;
      continue;
    }
    const channels: object[] = [];
    const samplers: object[] = [];
    for (const channel of animation.channels) {
      // A channel without a node is valid: an extension names its target.
      if (channel && !inScene.has(channel.target.node ?? -1)) continue;
      const sampler = channel && writeSampler(channel, animation.samplers[channel.sampler], values, writer, shapesOf);
      if (!sampler) {
        leftOut++;
        continue;
      }
      channels.push({ sampler: samplers.length, target: channel.target });
      samplers.push(sampler);
    }
    if (channels.length > 0) written.push({ name: animation.name, channels, samplers });
  }
  return { animations: written, leftOut };
}

function writeSampler(
  { target: { node, path } }: GltfChannel,
  sampler: GltfAnimationSampler | undefined,
  values: AccessorValues,
  writer: GltfWriter,
  shapesOf: (node: number) => number,
): object | undefined {
  if (!sampler || path === 'pointer') return undefined;
  const { input, output, interpolation = 'LINEAR' } = sampler;
  const size = path === 'weights' ? 1 : VALUES_PER_KEY[path];
  const perKey = path === 'weights' ? shapesOf(node!) : 1;
  const times = readFinite(values, input, 1);
  const keys = readFinite(values, output, size);
  if (!times?.length || !keys || perKey === 0) return undefined;
  const expected = times.length * size * perKey * (interpolation === 'CUBICSPLINE' ? SPLINE_VALUES : 1);
  if (keys.length !== expected || !isRising(times)) return undefined;
  return { input: writer.add(times, 1), output: writer.add(keys, size), interpolation };
}

/** The values of an accessor, or undefined if data is missing, not finite or of another size. */
function readFinite(values: AccessorValues, accessor: number, size: number): Float32Array | undefined {
  const floats = values.sizeOf(accessor) === size ? values.tryFloats(accessor) : undefined;
  return floats?.every(Number.isFinite) ? floats : undefined;
}

const isRising = (times: Float32Array): boolean => times.every((time, i) => i === 0 || time >= times[i - 1]);
