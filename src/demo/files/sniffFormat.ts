import { extensionOf } from './common/fileName.js';
import { ModelError } from './common/ModelError.js';
import type { SceneFormat } from './scenes/readScene.js';
import { binaryStlLength } from './stl/readStl.js';

/** What a file is read as. A ZIP archive may be a model in itself, or hold one. */
export type ModelFormat = 'glb' | 'gltf' | 'obj' | 'ply' | 'stl' | 'zip' | SceneFormat;

/** Extensions of main files, in order of preference. Other files of a drop only belong to a main file. */
export const MODEL_EXTENSIONS: readonly string[] = [
  'glb',
  'gltf',
  'obj',
  'fbx',
  'dae',
  'usdz',
  'usdc',
  'usda',
  'usd',
  '3mf',
  '3ds',
  'wrl',
  'ply',
  'stl',
  'zip',
];

const READ = 'GLB, glTF, OBJ, FBX, DAE, USDZ, 3MF, 3DS, VRML, PLY and STL, also in a ZIP';

/**
 * Detects the format of a file from its content, and from its name only if the content is ambiguous.
 *
 * @param name the file's name, without a `.gz`
 * @throws ModelError saying what the file is instead
 */
export function sniffFormat(name: string, bytes: Uint8Array): ModelFormat {
  if (bytes.length === 0) throw new ModelError(`${name} is empty.`);
  const extension = extensionOf(name) ?? '';
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, 2048));
  const known = BEGINNINGS.find(([, beginning]) => beginning.test(head))?.[0] ?? (is3ds(bytes) ? '3ds' : undefined);
  if (known) return known;
  const cloud = POINTS.find(([, beginning, extensions]) => beginning.test(head) || extensions.includes(extension))?.[0];
  if (cloud) throw new ModelError(`${name} holds ${cloud}, not triangles; only surfaces can be hatched.`);
  const foreign = FOREIGN.find(([, beginning]) => beginning.test(head))?.[0];
  if (foreign) throw new ModelError(`${name} is ${foreign}, which this page does not read; save it as GLB, say.`);
  const other = OTHER_KINDS.find(([, beginning]) => beginning.test(head))?.[0];
  if (other) throw new ModelError(`${name} is ${other}, not a 3D model.`);
  if (binaryStlLength(bytes) !== undefined || /^\s*(#.*\s+)*solid\b[\s\S]*\bfacet\b/i.test(head)) return 'stl';
  if (extension === 'obj' || /^\s*v\s+-?[\d.]/m.test(head)) return 'obj';
  if (MODEL_EXTENSIONS.includes(extension)) {
    throw new ModelError(`${name} is not a ${extension.toUpperCase()} file inside, or it was cut short.`);
  }
  throw new ModelError(`${name} is not a model this page can read; it takes ${READ}.`);
}

/** How files of a format begin. */
const BEGINNINGS: readonly [format: ModelFormat, beginning: RegExp][] = [
  ['glb', /^glTF/],
  ['ply', /^ply\s/],
  ['fbx', /^Kaydara FBX Binary|^\s*(;.*\s+)*FBXHeaderExtension\s*:/],
  ['usd', /^PXR-USDC|^#usda\s/],
  ['wrl', /^#VRML V2/],
  ['dae', /^\s*(<\?xml|<!--|<COLLADA)[\s\S]*<COLLADA\b/],
  // Biome takes the signature for control characters.
  ['zip', new RegExp(`^PK${String.fromCharCode(3, 4)}`)],
  ['gltf', /^\s*\{/],
];

/** Points instead of surfaces, by how their files begin or are named. */
const POINTS: readonly [what: string, beginning: RegExp, extensions: readonly string[]][] = [
  ['Gaussian splats', /^NGSP/, ['splat', 'ksplat', 'spz', 'sog']],
  ['a cloud of points', /^(# \.PCD|LASF|ASTM-E57)/, ['pcd', 'las', 'laz', 'e57', 'xyz', 'pts', 'ptx']],
];

/** Models of other programs. */
const FOREIGN: readonly [what: string, beginning: RegExp][] = [
  ['a Blender file', /^BLENDER/],
  ['a STEP file', /^ISO-10303-21/],
  ['a VRML file of version 1', /^#VRML V1|^#Inventor/],
  ['an X3D file', /^\s*<[\s\S]*<X3D\b/],
  ['an AMF file', /^\s*<[\s\S]*<amf\b/],
];

/** What is often dropped by mistake. */
const OTHER_KINDS: readonly [what: string, beginning: RegExp][] = [
  ['a web page', /^\s*<(!doctype\s+html|html|head|body)/i],
  ['an XML file', /^\s*(<\?xml|<svg)/i],
  ['a picture', /^(.PNG\r\n|\xff\xd8\xff|GIF8)/],
  ['a PDF document', /^%PDF/],
];

/** Whether bytes begin as 3DS does: with a chunk that holds all others, and one of those that come first. */
function is3ds(bytes: Uint8Array): boolean {
  if (bytes.length < 12 || bytes[0] !== 0x4d || bytes[1] !== 0x4d) return false;
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  return view.getUint32(2, true) <= bytes.length && FIRST_3DS_CHUNKS.includes(view.getUint16(6, true));
}

const FIRST_3DS_CHUNKS = [0x0001, 0x0002, 0x3d3d, 0x3d3e, 0xb000];
