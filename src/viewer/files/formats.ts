import type { FileChangeKind } from './common/fileChanges.js';
import { ModelError } from './common/ModelError.js';
import { extensionOf } from './common/ModelFile.js';
import type { FindFile, Surroundings } from './common/Surroundings.js';
import type { ReadGltf } from './gltf/readGltf.js';
import type { NotedMesh } from './mesh/PlainMesh.js';
import type { LoadedScene } from './scenes/LoadedScene.js';

/** The beginning of a file, by which its format is detected. */
interface FileStart {
  /** The whole file. */
  bytes: Uint8Array;
  /** Its first bytes, one character per byte. */
  head: string;
}

/** The input of a format's reader. */
export interface FormatFile {
  bytes: Uint8Array;
  /** The file's name for messages. */
  name: string;
  /** Finds the files that the model refers to. */
  findFile: FindFile;
  loadDraco: Surroundings['loadDraco'];
  /** The material variant: its index, or as text its name or its number counted from 1. */
  variant?: string | number | undefined;
  /** Kinds of changes that are switched from what is usual. */
  switched: readonly FileChangeKind[];
}

/** The three.js loader of a format, for copied code. */
export interface FormatLoader {
  name: string;
  /** The name of its module, if that differs. */
  module?: string;
  /** The result of the loader: an object, something with a `scene`, or a geometry. */
  gives: 'object' | 'scene' | 'geometry';
}

/** A model format. */
export interface ModelFormat {
  /** The name for users. */
  name: string;
  /** File extensions, in lower case and without the dot. */
  extensions: readonly [string, ...string[]];
  /** Extensions of files that such a model may refer to, other than pictures. */
  companions?: readonly string[];
  /** Detects the format by a signature that all its files have. */
  hasSignature?: (start: FileStart) => boolean;
  /** Detects a format without a signature. Called when no signature matched. */
  looksLike?: (start: FileStart) => boolean;
  /** Whether the extension decides when nothing was detected. */
  isBelieved?: boolean;
  /** Whether a ZIP archive with these paths is a model of the format. */
  isPackage?: (paths: readonly string[]) => boolean;
  /** The up axis of the format. */
  up: 'y' | 'z';
  /** Whether the files state their up axis, so that it is not guessed from the shape. */
  isUpCertain?: boolean;
  /** Whether the files say which side of a triangle is its front, so that nothing is turned. */
  isWindingCertain?: boolean;
  /** Whether the files say which surfaces are drawn from both sides. */
  isSideCertain?: boolean;
  /** Whether models usually lie flat, as those for 3D printers do. */
  liesFlat?: boolean;
  /** Undefined if three.js has no loader. */
  loader: FormatLoader | undefined;
  /** Reads a file. @throws ModelError, or the loader's Error */
  read: (file: FormatFile) => Promise<ReadGltf | LoadedScene | NotedMesh>;
}

const GLTF = {
  up: 'y',
  isUpCertain: true,
  isWindingCertain: true,
  isSideCertain: true,
  companions: ['bin'],
  loader: { name: 'GLTFLoader', gives: 'scene' },
} as const;

async function readAnyGltf(
  { bytes, name, findFile, loadDraco, variant, switched }: FormatFile,
  isBinary: boolean,
): Promise<ReadGltf> {
  const { readGltf } = await import('./gltf/readGltf.js');
  const [showsHidden, hasBothSides] = (['hidden', 'sides'] as const).map((kind) => switched.includes(kind));
  return readGltf(bytes, name, isBinary, findFile, { loadDraco, variant, showsHidden, hasBothSides });
}

/** All formats that are read. If several models are dropped together, the one whose format comes first is shown. */
export const FORMATS: readonly ModelFormat[] = [
  {
    ...GLTF,
    name: 'GLB',
    extensions: ['glb'],
    hasSignature: ({ head }) => head.startsWith('glTF'),
    read: (file) => readAnyGltf(file, true),
  },
  {
    ...GLTF,
    name: 'glTF',
    extensions: ['gltf'],
    hasSignature: ({ head }) => /^\s*\{/.test(head),
    read: (file) => readAnyGltf(file, false),
  },
  {
    name: 'OBJ',
    extensions: ['obj'],
    companions: ['mtl'],
    looksLike: ({ head }) => /^\s*v\s+-?[\d.]/m.test(head),
    isBelieved: true,
    up: 'y',
    loader: { name: 'OBJLoader', gives: 'object' },
    read: async ({ bytes, findFile }) => (await import('./formats/readObj.js')).readObj(bytes, findFile),
  },
  {
    name: 'FBX',
    extensions: ['fbx'],
    hasSignature: ({ head }) => /^Kaydara FBX Binary|^\s*(;[^\n\r]*[\n\r]\s*)*FBXHeaderExtension\s*:/.test(head),
    up: 'y',
    loader: { name: 'FBXLoader', gives: 'object' },
    read: async ({ bytes, name }) => (await import('./scenes/readFbx.js')).readFbx(bytes, name),
  },
  {
    name: 'DAE',
    extensions: ['dae'],
    hasSignature: ({ head }) => /^\s*((<\?xml|<!--)[\s\S]*)?<COLLADA\b/.test(head),
    up: 'y',
    loader: { name: 'ColladaLoader', gives: 'scene' },
    read: async ({ bytes, name }) => (await import('./scenes/readCollada.js')).readCollada(bytes, name),
  },
  {
    name: 'USDZ',
    extensions: ['usdz', 'usdc', 'usda', 'usd'],
    hasSignature: ({ head }) => /^PXR-USDC|^#usda\s/.test(head),
    // The first file of a USDZ package is its root layer.
    isPackage: ([first = '']) => /\.usd[ac]?$/i.test(first),
    up: 'y',
    isWindingCertain: true,
    loader: { name: 'USDLoader', gives: 'object' },
    read: async ({ bytes, name, switched }) =>
      (await import('./scenes/readUsd.js')).readUsd(bytes, name, switched.includes('hidden')),
  },
  {
    name: '3MF',
    extensions: ['3mf'],
    isPackage: (paths) => paths.some((path) => /^\/?3D\/[^/]*\.model$/i.test(path)),
    up: 'z',
    liesFlat: true,
    loader: { name: 'ThreeMFLoader', module: '3MFLoader', gives: 'object' },
    read: async ({ bytes, name }) => (await import('./scenes/read3mf.js')).read3mf(bytes, name),
  },
  {
    name: '3DS',
    extensions: ['3ds'],
    hasSignature: ({ bytes }) => is3ds(bytes),
    up: 'z',
    loader: { name: 'TDSLoader', gives: 'object' },
    read: async ({ bytes, name }) => (await import('./scenes/read3ds.js')).read3ds(bytes, name),
  },
  {
    name: 'VRML',
    extensions: ['wrl'],
    hasSignature: ({ head }) => head.startsWith('#VRML V2'),
    up: 'y',
    loader: { name: 'VRMLLoader', gives: 'object' },
    read: async ({ bytes, name }) => (await import('./scenes/readVrml.js')).readVrml(bytes, name),
  },
  {
    name: 'PLY',
    extensions: ['ply'],
    hasSignature: ({ head }) => /^ply\s/.test(head),
    up: 'y',
    loader: { name: 'PLYLoader', gives: 'geometry' },
    read: async ({ bytes, name }) => (await import('./formats/readPly.js')).readPly(bytes, name),
  },
  {
    name: 'STL',
    extensions: ['stl'],
    looksLike: ({ bytes, head }) =>
      binaryStlLength(bytes) !== undefined || /^\s*(#[^\n\r]*[\n\r]\s*)*solid\b[\s\S]*\bfacet\b/i.test(head),
    up: 'z',
    liesFlat: true,
    loader: { name: 'STLLoader', gives: 'geometry' },
    read: async ({ bytes }) => (await import('./formats/readStl.js')).readStl(bytes, binaryStlLength(bytes)),
  },
  {
    name: 'OFF',
    extensions: ['off'],
    hasSignature: ({ head }) => /^\s*(#[^\n\r]*[\n\r]\s*)*(ST)?C?N?4?n?OFF(?![a-z])/i.test(head),
    isBelieved: true,
    up: 'y',
    loader: undefined,
    read: async ({ bytes, name }) => (await import('./formats/readOff.js')).readOff(bytes, name),
  },
];

/** Extensions of main files, in order of preference. All other dropped files are companions. */
export const MODEL_EXTENSIONS: readonly string[] = [...FORMATS.flatMap(({ extensions }) => extensions), 'zip'];

/** Extensions of pictures. */
const PICTURES = ['png', 'jpg', 'jpeg', 'webp', 'bmp', 'gif', 'tga'];

/** Extensions of files that models may refer to. */
export const COMPANION_EXTENSIONS: readonly string[] = [
  ...new Set(FORMATS.flatMap(({ companions = [] }) => companions)),
  ...PICTURES,
];

/** The names of all formats in a sentence. @param junction the word before the last name */
export function formatNames(junction: 'and' | 'or'): string {
  const names = FORMATS.map(({ name }) => name);
  return `${names.slice(0, -1).join(', ')} ${junction} ${names.at(-1)}`;
}

/** The format for an extension, which is in lower case and without the dot. */
export const formatOf = (extension: string): ModelFormat | undefined =>
  FORMATS.find(({ extensions }) => extensions.includes(extension));

/** The chunks that can come first within the main chunk. */
const FIRST_CHUNKS = [0x0001, 0x0002, 0x3d3d, 0x3d3e, 0xb000];

/** Whether bytes begin with the main chunk of a 3DS file and one of the possible first chunks. */
function is3ds(bytes: Uint8Array): boolean {
  if (bytes.length < 12 || bytes[0] !== 0x4d || bytes[1] !== 0x4d) return false;
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  return view.getUint32(2, true) <= bytes.length && FIRST_CHUNKS.includes(view.getUint16(6, true));
}

/**
 * Detects the format of a file by its content, and by its name only if the content is ambiguous. A ZIP archive may be a model in itself, or
 * contain one.
 *
 * @param name the file's name, without a `.gz`
 * @param extension used instead of the name's extension
 * @throws ModelError that says what the file is instead
 */
export function sniffFormat(name: string, bytes: Uint8Array, extension = extensionOf(name) ?? ''): ModelFormat | 'zip' {
  if (bytes.length === 0) throw new ModelError(`${name} is empty.`);
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, 2048));
  const start: FileStart = { bytes, head };
  if (head.startsWith(ZIP_SIGNATURE)) return 'zip';
  const known = FORMATS.find(({ hasSignature }) => hasSignature?.(start));
  if (known) return known;
  const cloud = POINTS.find(([, beginning, extensions]) => beginning.test(head) || extensions.includes(extension))?.[0];
  if (cloud) throw new ModelError(`${name} holds ${cloud}, not triangles; only surfaces can be hatched.`);
  const foreign = FOREIGN.find(([, beginning]) => beginning.test(head))?.[0];
  if (foreign) throw new ModelError(`${name} is ${foreign}, which this page does not read; save it as GLB, say.`);
  const other = OTHER_KINDS.find(([, beginning]) => beginning.test(head))?.[0];
  if (other) throw new ModelError(`${name} is ${other}, not a 3D model.`);
  const alike = FORMATS.find(({ looksLike }) => looksLike?.(start));
  if (alike) return alike;
  const named = formatOf(extension);
  if (named?.isBelieved) return named;
  if (named || extension === 'zip') {
    const article = /^[fos]/.test(extension) ? 'an' : 'a';
    throw new ModelError(`${name} is not ${article} ${extension.toUpperCase()} file inside, or it was cut short.`);
  }
  throw new ModelError(`${name} is not a model this page can read; it takes ${formatNames('and')}, also in a ZIP.`);
}

/** Built from codes, because Biome reports control characters in literals. */
const ZIP_SIGNATURE = `PK${String.fromCharCode(3, 4)}`;

/** Point formats, which have no surfaces, by signature or extension. */
const POINTS: readonly [what: string, beginning: RegExp, extensions: readonly string[]][] = [
  ['Gaussian splats', /^NGSP/, ['splat', 'ksplat', 'spz', 'sog']],
  ['a cloud of points', /^(# \.PCD|LASF|ASTM-E57)/, ['pcd', 'las', 'laz', 'e57', 'xyz', 'pts', 'ptx']],
];

/** Unsupported model formats, by signature. */
const FOREIGN: readonly [what: string, beginning: RegExp][] = [
  ['a Blender file', /^BLENDER/],
  ['a STEP file', /^ISO-10303-21/],
  ['a VRML file of version 1', /^#VRML V1|^#Inventor/],
  ['an X3D file', /^\s*(<[\s\S]*)?<X3D\b/],
  ['an AMF file', /^\s*(<[\s\S]*)?<amf\b/],
];

/** Other files that are often dropped by mistake, by signature. */
const OTHER_KINDS: readonly [what: string, beginning: RegExp][] = [
  ['a web page', /^\s*<(!doctype\s+html|html|head|body)/i],
  ['an XML file', /^\s*(<\?xml|<svg)/i],
  ['a picture', /^(.PNG\r\n|\xff\xd8\xff|GIF8)/],
  ['a PDF document', /^%PDF/],
];

const HEADER_BYTES = 84;
const TRIANGLE_BYTES = 50;

/** The length of a binary STL file according to its triangle count; undefined if the bytes cannot be such a file. */
function binaryStlLength(bytes: Uint8Array): number | undefined {
  if (bytes.length < HEADER_BYTES) return undefined;
  const count = new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
  const length = HEADER_BYTES + count * TRIANGLE_BYTES;
  return count > 0 && length <= bytes.length ? length : undefined;
}
