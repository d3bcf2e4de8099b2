import { extensionOf } from './common/fileName.js';
import { ModelError } from './common/ModelError.js';
import { type FileStart, FORMATS, formatNames, formatOf, type ModelFormat } from './formats.js';

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
  ['an X3D file', /^\s*<[\s\S]*<X3D\b/],
  ['an AMF file', /^\s*<[\s\S]*<amf\b/],
];

/** Other files that are often dropped by mistake, by signature. */
const OTHER_KINDS: readonly [what: string, beginning: RegExp][] = [
  ['a web page', /^\s*<(!doctype\s+html|html|head|body)/i],
  ['an XML file', /^\s*(<\?xml|<svg)/i],
  ['a picture', /^(.PNG\r\n|\xff\xd8\xff|GIF8)/],
  ['a PDF document', /^%PDF/],
];
