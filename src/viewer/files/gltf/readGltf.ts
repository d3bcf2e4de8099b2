import { Matrix4 } from 'three';
import type { FileChange } from '../common/fileChanges.js';
import { counted, ModelError, shownName } from '../common/ModelError.js';
import { type ModelExtras, movedExtras } from '../common/ModelExtras.js';
import { baseName, readUri } from '../common/ModelFile.js';
import { BITMAPS, type FindFile, type Surroundings } from '../common/Surroundings.js';
import type { PlainMesh } from '../mesh/PlainMesh.js';
import { mergeScene } from '../scenes/mergeScene.js';
import { type ChosenScene, chooseScene } from './chooseScene.js';
import type { DracoSource } from './GltfGeometry.js';
import { type AccessorValues, GltfValues } from './GltfValues.js';
import { type GltfDocument, readGltfDocument } from './gltfDocument.js';
import { gltfExtras, useVariant } from './gltfExtras.js';
import { collectPictures, drawnMaterials, textureSource } from './gltfMaterials.js';
import { type GltfParts, parseGltf } from './parseGltf.js';
import { dracoSource, type PlainGltf, unpackGltf } from './unpackGltf.js';

const GLB_JSON = 0x4e4f534a;
const GLB_BINARY = 0x004e4942;

/** Splits a GLB file into its JSON and its binary chunk. */
function splitGlb(bytes: Uint8Array, name: string): { text: string; binary: Uint8Array | undefined } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 20) throw new ModelError(`${name} is cut short: it ends within its header.`);
  const version = view.getUint32(4, true);
  if (version !== 2) throw new ModelError(`${name} is glTF version ${version}; this page reads version 2.`);
  if (view.getUint32(8, true) > bytes.length) {
    throw new ModelError(
      `${name} is cut short: it should have ${view.getUint32(8, true).toLocaleString('en')} bytes and has ${bytes.length.toLocaleString('en')}.`,
    );
  }
  let text: string | undefined;
  let binary: Uint8Array | undefined;
  for (let offset = 12; offset + 8 <= bytes.length; ) {
    const length = view.getUint32(offset, true);
    const kind = view.getUint32(offset + 4, true);
    const chunk = bytes.subarray(offset + 8, offset + 8 + length);
    if (chunk.length < length) throw new ModelError(`${name} is cut short: one of its parts ends too early.`);
    if (kind === GLB_JSON) text ??= new TextDecoder().decode(chunk);
    else if (kind === GLB_BINARY) binary ??= chunk;
    offset += 8 + length;
  }
  if (text === undefined) throw new ModelError(`${name} has no description of its scene.`);
  return { text, binary };
}

/** Larger scenes would block the main thread for too long; they are merged to one static mesh. */
const MAX_SCENE = { vertices: 300_000, nodes: 5_000, draws: 2_000, channels: 20_000 };

/** The result of reading a glTF file. */
export interface ReadGltf {
  /** One merged mesh; or the checked parts of the file where a merged mesh would lose something, such as motion. */
  content: PlainMesh | GltfParts;
  /** The number of triangles left out because a corner was missing or NaN. */
  broken: number;
  /** Notes for the caption: what was chosen, and what was left out. */
  notes: string[];
  /** Details for the longer text that opens on request. */
  details: string[];
  /** Changes that were made to what the file says. */
  changes?: FileChange[];
  /** Names of pictures that were not dropped along. */
  missing: string[];
  /** Cameras, lights and variants, in the space of `content`. */
  extras?: ModelExtras;
  /** The number of pictures that could not be read. */
  lostPictures?: number;
}

/**
 * Reads GLB, or glTF with its files, with or without Draco or meshopt compression. Fetches nothing.
 *
 * @param options.variant material variant: its index, or as text its name or its number counted from 1
 * @param options.showsHidden whether nodes that are hidden in the file are shown
 * @param options.hasBothSides whether both sides of all surfaces are drawn, whatever their materials say
 * @throws ModelError
 */
export async function readGltf(
  bytes: Uint8Array,
  name: string,
  isBinary: boolean,
  findFile: FindFile,
  {
    loadDraco = BITMAPS.loadDraco,
    variant,
    showsHidden = false,
    hasBothSides = false,
  }: Partial<Pick<Surroundings, 'loadDraco'>> & {
    variant?: string | number | undefined;
    showsHidden?: boolean;
    hasBothSides?: boolean;
  } = {},
): Promise<ReadGltf> {
  const { text, binary } = isBinary
    ? splitGlb(bytes, name)
    : { text: new TextDecoder().decode(bytes), binary: undefined };
  const { document, leftOut, unread } = readGltfDocument(text, name);
  if (variant !== undefined) useVariant(document, variant, name);
  const chosen = chooseScene(document, name, showsHidden);
  const values = new GltfValues(document, await collectBuffers(document, name, binary, findFile), name);
  await values.prepare();
  const draco = dracoSource(document, values, name, loadDraco);
  const { plain, parts, isPictured, read } = await readParts(document, chosen, values, name, findFile, draco);
  if (leftOut > 0) read.details.push(counted(leftOut, 'damaged setting', 'left out'));
  if (unread.length > 0) read.details.push(unreadDetail(unread));
  const glows = document.materials.some((material) => material?.emissiveFactor?.some((value) => value > 0));
  const isScene = plain.moves || isPictured || glows;
  if (isScene && parts) return { ...read, content: { ...parts, hasBothSides } };
  if (isScene) read.notes.push(`too large to be drawn ${plain.moves ? 'in motion' : 'with its pictures'}`);
  const still = withMaterials({ ...plain, json: { ...plain.json, animations: [] } }, document, []);
  const { root } = await parseGltf({ ...still, hasBothSides });
  const toMesh = new Matrix4();
  const content = mergeScene(root, undefined, toMesh, read.notes, true);
  return { ...read, content, extras: movedExtras(read.extras, toMesh) };
}

/** Checks the values of a document and collects its pictures. `parts` are undefined if it is too large to be drawn as a scene. */
export async function readParts(
  document: GltfDocument,
  chosen: ChosenScene,
  values: AccessorValues,
  name: string,
  findFile: FindFile,
  draco: DracoSource,
) {
  const plain = await unpackGltf(document, chosen, values, name, draco);
  const { pictures, missing, lostPictures, notes } = await collectPictures(document, values, findFile);
  return {
    plain,
    parts: isSmall(plain) ? withMaterials(plain, document, pictures) : undefined,
    isPictured: pictures.some(Boolean),
    read: {
      broken: plain.broken,
      notes: [...chosen.notes, ...plain.notes, ...notes],
      details: [...chosen.details, ...plain.details],
      changes: chosen.changes,
      missing,
      lostPictures,
      extras: gltfExtras(document, chosen),
    },
  };
}

/** At most this many extensions are named. */
const NAMED = 5;

function unreadDetail(names: readonly string[]): string {
  const more = names.length > NAMED ? [`${names.length - NAMED} more`] : [];
  const list = [...names.slice(0, NAMED).map(shownName), ...more].join(', ');
  return names.length === 1 ? `the glTF extension ${list} is not read` : `the glTF extensions ${list} are not read`;
}

function isSmall({ json, vertices, draws }: PlainGltf): boolean {
  const channels = (json.animations as { channels: unknown[] }[]).reduce(
    (sum, { channels }) => sum + channels.length,
    0,
  );
  return (
    vertices <= MAX_SCENE.vertices &&
    json.nodes.length <= MAX_SCENE.nodes &&
    draws <= MAX_SCENE.draws &&
    channels <= MAX_SCENE.channels
  );
}

function withMaterials(
  { json, arrays }: PlainGltf,
  document: GltfDocument,
  pictures: GltfParts['pictures'],
): GltfParts {
  return {
    json: {
      ...json,
      materials: drawnMaterials(document, (image) => pictures[image] !== undefined),
      textures: document.textures.map(() => ({})),
    },
    arrays,
    textures: document.textures.map((texture, i) => ({
      image: textureSource(document, i) ?? -1,
      sampler: document.samplers[texture?.sampler ?? -1],
    })),
    pictures,
    bitmaps: [],
    hasBothSides: false,
  };
}

async function collectBuffers(
  { buffers }: GltfDocument,
  name: string,
  binary: Uint8Array | undefined,
  findFile: FindFile,
): Promise<Uint8Array[]> {
  const collected: Uint8Array[] = [];
  for (const [i, { uri, byteLength = 0, extensions }] of buffers.entries()) {
    if (uri === undefined && i === 0 && binary) collected.push(binary);
    // The fallback of a compressed buffer has no data of its own.
    else if (uri === undefined && extensions) collected.push(new Uint8Array(0));
    else if (uri === undefined) throw new ModelError(`${name} is cut short: its binary part is missing.`);
    else {
      const found = await readUri(uri, findFile);
      if (!found) throw new ModelError(`${name} needs ${shownName(baseName(uri))}; drop both files together.`);
      if (found.length < byteLength) {
        const short = uri.startsWith('data:') ? name : shownName(baseName(uri));
        throw new ModelError(`${short} is cut short: ${name} expects more data in it.`);
      }
      collected.push(found);
    }
  }
  return collected;
}
