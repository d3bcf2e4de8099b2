import type { FindFile } from './common/FindFile.js';
import type { Surroundings } from './common/Surroundings.js';
import { binaryStlLength } from './formats/binaryStlLength.js';
import type { ReadGltf } from './gltf/readGltf.js';
import type { NotedMesh } from './mesh/PlainMesh.js';
import { is3ds } from './scenes/is3ds.js';
import type { LoadedScene } from './scenes/LoadedScene.js';

/** The beginning of a file, by which its format is recognised. */
export interface FileStart {
  /** The whole file. */
  bytes: Uint8Array;
  /** Its first bytes, each as a character. */
  head: string;
}

/** A file for the reader of its format. */
export interface FormatFile {
  bytes: Uint8Array;
  /** Its name as messages give it. */
  name: string;
  /** Finds the files that it refers to. */
  findFile: FindFile;
  loadDraco: Surroundings['loadDraco'];
  /** The variant of its materials: its index, or its name or its number from 1 on as text. */
  variant?: string | number | undefined;
}

/** The loader of three.js that copied code reads a format with. */
export interface FormatLoader {
  name: string;
  /** The name of its module, if that is another one. */
  module?: string;
  /** What it returns: an object, something with a `scene`, or a geometry. */
  gives: 'object' | 'scene' | 'geometry';
}

/** What the page knows of a format of models. */
export interface ModelFormat {
  /** The name that users read. */
  name: string;
  /** Extensions of its files, in lower case and without the dot. */
  extensions: readonly [string, ...string[]];
  /** Extensions of files that such a model may refer to, beside pictures. */
  companions?: readonly string[];
  /** Recognises a file by what all files of the format begin with. */
  hasSignature?: (start: FileStart) => boolean;
  /** Recognises a file of a format without a signature. It is asked when nothing else was recognised. */
  looksLike?: (start: FileStart) => boolean;
  /** Whether a file with such an extension is read as this format when nothing was recognised. */
  isBelieved?: boolean;
  /** Whether a ZIP archive with these files is a model of the format in itself. */
  isPackage?: (paths: readonly string[]) => boolean;
  /** The axis that points up in its files. */
  up: 'y' | 'z';
  /** Whether files say which axis points up, so that it is not derived from the shape. */
  isUpCertain?: boolean;
  /** Whether models lie on their flat side as a rule, as those for 3D printers do. */
  liesFlat?: boolean;
  /** Undefined if three.js has none. */
  loader: FormatLoader | undefined;
  /** Reads a file. @throws ModelError, or Error as the loader has it */
  read: (file: FormatFile) => Promise<ReadGltf | LoadedScene | NotedMesh>;
}

const GLTF = {
  up: 'y',
  isUpCertain: true,
  companions: ['bin'],
  loader: { name: 'GLTFLoader', gives: 'scene' },
} as const;

/** Every format that the page reads. Of several models in a drop the one is shown whose format comes first. */
export const FORMATS: readonly ModelFormat[] = [
  {
    ...GLTF,
    name: 'GLB',
    extensions: ['glb'],
    hasSignature: ({ head }) => head.startsWith('glTF'),
    read: async ({ bytes, name, findFile, loadDraco, variant }) =>
      (await import('./gltf/readGltf.js')).readGltf(bytes, name, true, findFile, loadDraco, variant),
  },
  {
    ...GLTF,
    name: 'glTF',
    extensions: ['gltf'],
    hasSignature: ({ head }) => /^\s*\{/.test(head),
    read: async ({ bytes, name, findFile, loadDraco, variant }) =>
      (await import('./gltf/readGltf.js')).readGltf(bytes, name, false, findFile, loadDraco, variant),
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
    hasSignature: ({ head }) => /^\s*(<\?xml|<!--|<COLLADA)[\s\S]*<COLLADA\b/.test(head),
    up: 'y',
    loader: { name: 'ColladaLoader', gives: 'scene' },
    read: async ({ bytes, name }) => (await import('./scenes/readCollada.js')).readCollada(bytes, name),
  },
  {
    name: 'USDZ',
    extensions: ['usdz', 'usdc', 'usda', 'usd'],
    hasSignature: ({ head }) => /^PXR-USDC|^#usda\s/.test(head),
    // The first file of a package is its outermost layer.
    isPackage: ([first = '']) => /\.usd[ac]?$/i.test(first),
    up: 'y',
    loader: { name: 'USDLoader', gives: 'object' },
    read: async ({ bytes, name }) => (await import('./scenes/readUsd.js')).readUsd(bytes, name),
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
    read: async ({ bytes }) => (await import('./formats/readStl.js')).readStl(bytes),
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

/** Extensions of main files, in order of preference. Other files of a drop only belong to a main file. */
export const MODEL_EXTENSIONS: readonly string[] = [...FORMATS.flatMap(({ extensions }) => extensions), 'zip'];

/** Extensions of pictures on models. */
const PICTURES = ['png', 'jpg', 'jpeg', 'webp', 'bmp', 'gif', 'tga'];

/** Extensions of files that models may refer to. */
export const COMPANION_EXTENSIONS: readonly string[] = [
  ...new Set(FORMATS.flatMap(({ companions = [] }) => companions)),
  ...PICTURES,
];

/** The names of all formats in a sentence. @param junction the word before the last of them */
export function formatNames(junction: 'and' | 'or'): string {
  const names = FORMATS.map(({ name }) => name);
  return `${names.slice(0, -1).join(', ')} ${junction} ${names.at(-1)}`;
}

/** The format of files with an extension, in lower case and without the dot. */
export const formatOf = (extension: string): ModelFormat | undefined =>
  FORMATS.find(({ extensions }) => extensions.includes(extension));
