import { extensionOf } from './fileName.js';
import { ModelError } from './ModelError.js';
import { binaryStlLength } from './readStl.js';

export type ModelFormat = 'glb' | 'gltf' | 'obj' | 'ply' | 'stl';

/** Formats of main files, in order of preference. Other files of a drop only belong to a main file. */
export const MODEL_EXTENSIONS: readonly ModelFormat[] = ['glb', 'gltf', 'obj', 'ply', 'stl'];

/**
 * Detects the format of a file from its content, and from its name only if the content is ambiguous.
 *
 * @param name the file's name, without a `.gz`
 * @throws ModelError saying what the file is instead
 */
export function sniffFormat(name: string, bytes: Uint8Array): ModelFormat {
  if (bytes.length === 0) throw new ModelError(`${name} is empty.`);
  const extension = extensionOf(name);
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, 2048));
  if (head.startsWith('glTF')) return 'glb';
  if (/^ply\s/.test(head)) return 'ply';
  const other = otherKind(bytes, head);
  if (other) throw new ModelError(`${name} is ${other}, not a 3D model.`);
  if (/^\s*(\uFEFF|ï»¿)?\{/.test(head)) return 'gltf';
  if (binaryStlLength(bytes) !== undefined || /^\s*(#.*\s+)*solid\b[\s\S]*\bfacet\b/i.test(head)) return 'stl';
  if (extension === 'obj' || /^\s*v\s+-?[\d.]/m.test(head)) return 'obj';
  if (MODEL_EXTENSIONS.includes(extension as ModelFormat)) {
    throw new ModelError(`${name} is not a ${extension!.toUpperCase()} file inside, or it was cut short.`);
  }
  throw new ModelError(`${name} is not a model this page can read; it takes GLB, glTF, OBJ, PLY and STL.`);
}

/** First bytes of files that are often dropped by mistake. */
const OTHER_KINDS: readonly [kind: string, beginning: readonly number[]][] = [
  ['a picture', [0x89, 0x50, 0x4e, 0x47]],
  ['a picture', [0xff, 0xd8, 0xff]],
  ['a picture', [0x47, 0x49, 0x46, 0x38]],
  ['a ZIP archive', [0x50, 0x4b, 0x03, 0x04]],
  ['a PDF document', [0x25, 0x50, 0x44, 0x46]],
];

function otherKind(bytes: Uint8Array, head: string): string | undefined {
  if (/^\s*<(!doctype\s+html|html|head|body)/i.test(head)) return 'a web page';
  if (/^\s*<\?xml|^\s*<svg/i.test(head)) return 'an XML file';
  return OTHER_KINDS.find(([, beginning]) => beginning.every((byte, i) => bytes[i] === byte))?.[0];
}
