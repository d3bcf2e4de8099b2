import { type BufferGeometry, Mesh } from 'three';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { checkPly } from './checkPly.js';
import { cleanMesh } from './cleanMesh.js';
import type { FindFile } from './FindFile.js';
import { baseName, extensionOf, withoutGz } from './fileName.js';
import { fitModel } from './fitModel.js';
import { gunzip } from './gunzip.js';
import { ModelError, toModelError } from './ModelError.js';
import { mergeScene } from './mergeScene.js';
import type { PlainMesh } from './PlainMesh.js';
import type { GltfParts } from './parseGltf.js';
import { readGltf } from './readGltf.js';
import { readObj } from './readObj.js';
import { MODEL_EXTENSIONS, sniffFormat } from './sniffFormat.js';

/** Of all files together. A model is held in memory several times while it is read. */
const MAX_BYTES = 512 * 1024 * 1024;

/** A file that was dropped or picked, or that holds a built-in model. */
export interface ModelFile {
  name: string;
  content: Blob;
}

/** A model that was read: one mesh, or the checked parts of a file that one mesh cannot show. */
export type ReadModel = ReadMesh | ReadParts;

interface Read {
  /** The name of the main file. */
  name: string;
  /** The up axis that is usual for the format. */
  upAxis: 'y' | 'z';
}

export interface ReadMesh extends Read {
  kind: 'mesh';
  mesh: PlainMesh;
  /** Number of triangles left out because a corner was missing or not a number. */
  broken: number;
}

export interface ReadParts extends Read {
  kind: 'parts';
  parts: GltfParts;
}

/**
 * Reads a model from one or several files: unpacks, detects the format, checks the header, parses, merges, removes
 * broken triangles and fits the rest into a unit sphere. A glTF file that is drawn as a scene is only checked and left
 * in its parts.
 *
 * @param onStage called with a few words on what is being done
 * @throws ModelError with one sentence for the user
 */
export async function readModel(files: readonly ModelFile[], onStage: (stage: string) => void): Promise<ReadModel> {
  const size = files.reduce((sum, file) => sum + file.content.size, 0);
  if (size > MAX_BYTES) {
    throw new ModelError(
      `The files have ${Math.round(size / 2 ** 20)} MB together; this page takes up to ${MAX_BYTES / 2 ** 20} MB.`,
    );
  }
  const main = chooseMain(files);
  onStage(`reading ${main.name}`);
  const bytes = await gunzip(new Uint8Array(await main.content.arrayBuffer()), main.name);
  const format = sniffFormat(withoutGz(main.name), bytes);
  const findFile: FindFile = async (uri) => {
    const wanted = baseName(safeDecode(uri)).toLowerCase();
    const file = files.find(({ name }) => baseName(name).toLowerCase() === wanted);
    return file && new Uint8Array(await file.content.arrayBuffer());
  };
  const parsed = await parse(format, bytes, main.name, findFile);
  const read: Read = { name: withoutGz(main.name), upAxis: format === 'stl' ? 'z' : 'y' };
  if ('document' in parsed) return { kind: 'parts', ...read, parts: parsed };
  onStage('looking over the triangles');
  const { mesh, broken } = cleanMesh(parsed);
  fitModel(mesh);
  return { kind: 'mesh', ...read, mesh, broken };
}

async function parse(
  format: string,
  bytes: Uint8Array,
  name: string,
  findFile: FindFile,
): Promise<PlainMesh | GltfParts> {
  try {
    switch (format) {
      case 'glb':
      case 'gltf':
        return await readGltf(bytes, name, format === 'glb', findFile);
      case 'obj':
        return await readObj(bytes, findFile);
      case 'ply':
        checkPly(bytes, name);
        return fromGeometry(new PLYLoader().parse(wholeBuffer(bytes)));
      default:
        return fromGeometry(new STLLoader().parse(wholeBuffer(bytes)));
    }
  } catch (error) {
    throw toModelError(name, error);
  }
}

function fromGeometry(geometry: BufferGeometry): PlainMesh {
  return mergeScene(new Mesh(geometry));
}

/** A buffer that holds exactly these bytes, because three's loaders take whole buffers only. */
function wholeBuffer(bytes: Uint8Array): ArrayBuffer {
  const isWhole = bytes.byteOffset === 0 && bytes.byteLength === bytes.buffer.byteLength;
  return (isWhole ? bytes.buffer : bytes.slice().buffer) as ArrayBuffer;
}

function safeDecode(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

function chooseMain(files: readonly ModelFile[]): ModelFile {
  const rank = (file: ModelFile): number => {
    const at = (MODEL_EXTENSIONS as readonly string[]).indexOf(extensionOf(withoutGz(file.name)) ?? '');
    return at === -1 ? MODEL_EXTENSIONS.length : at;
  };
  const [main] = [...files].sort((a, b) => rank(a) - rank(b));
  if (!main) throw new ModelError('There was no file in what was dropped.');
  return main;
}
