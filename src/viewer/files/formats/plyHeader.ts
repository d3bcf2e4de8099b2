import { ModelError } from '../common/ModelError.js';

/** A number type of PLY. */
export type PlyType = 'int8' | 'uint8' | 'int16' | 'uint16' | 'int32' | 'uint32' | 'float32' | 'float64';

/** The types by all their names. */
const TYPES: Readonly<Record<string, PlyType>> = {
  char: 'int8',
  int8: 'int8',
  uchar: 'uint8',
  uint8: 'uint8',
  short: 'int16',
  int16: 'int16',
  ushort: 'uint16',
  uint16: 'uint16',
  int: 'int32',
  int32: 'int32',
  uint: 'uint32',
  uint32: 'uint32',
  float: 'float32',
  float32: 'float32',
  double: 'float64',
  float64: 'float64',
};

/** Size of each type in a binary file, in bytes. */
export const PLY_BYTES: Readonly<Record<PlyType, number>> = {
  int8: 1,
  uint8: 1,
  int16: 2,
  uint16: 2,
  int32: 4,
  uint32: 4,
  float32: 4,
  float64: 8,
};

export interface PlyProperty {
  name: string;
  type: PlyType;
  /** For a list, the type of its length. */
  countType?: PlyType;
}

export interface PlyElement {
  name: string;
  count: number;
  properties: PlyProperty[];
}

export interface PlyHeader {
  format: 'ascii' | 'little' | 'big';
  /** The elements in file order. */
  elements: PlyElement[];
  /** The name of the texture from a comment, as several programs write it. */
  picture: string | undefined;
  /** The byte offset of the data. */
  end: number;
}

const MAX_HEADER_BYTES = 1_000_000;
const FORMATS: Readonly<Record<string, PlyHeader['format']>> = {
  ascii: 'ascii',
  binary_little_endian: 'little',
  binary_big_endian: 'big',
};

/**
 * Reads the header of a PLY file, with any kind of line end, comments anywhere, and its parts in any order.
 *
 * @throws ModelError
 */
export function readPlyHeader(bytes: Uint8Array, name: string): PlyHeader {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, MAX_HEADER_BYTES));
  // If lines end with CR alone, an LF after the last line belongs to the data.
  const lineEnd = /\r\n|\r|\n/.exec(head)?.[0] ?? '\n';
  const last = new RegExp(`(^|[\\r\\n])[ \\t]*end_header[ \\t]*(${lineEnd}|[\\r\\n]|$)`).exec(head);
  if (!last) throw new ModelError(`${name} is cut short: its PLY header has no end.`);
  const elements: PlyElement[] = [];
  let format: PlyHeader['format'] | undefined;
  let picture: string | undefined;
  for (const line of head.slice(0, last.index).split(/[\r\n]+/)) {
    const words = line.trim().split(/\s+/);
    if (/^comment TextureFile$/i.test(words.slice(0, 2).join(' '))) picture = words.slice(2).join(' ');
    else if (words[0] === 'format') format = FORMATS[words[1] ?? ''];
    else if (words[0] === 'element') elements.push({ name: words[1] ?? '', count: Number(words[2]), properties: [] });
    else if (words[0] === 'property') elements.at(-1)?.properties.push(property(words, name));
  }
  if (!format) throw new ModelError(`${name} does not say how its PLY data are stored.`);
  for (const element of elements) {
    if (!Number.isInteger(element.count) || element.count < 0) {
      throw new ModelError(`${name} is damaged: its header does not say how many "${element.name}" it holds.`);
    }
  }
  return { format, elements, picture, end: last.index + last[0].length };
}

function property(words: readonly string[], name: string): PlyProperty {
  const isList = words[1] === 'list';
  const type = TYPES[words[isList ? 3 : 1] ?? ''];
  const countType = isList ? TYPES[words[2] ?? ''] : undefined;
  if (!type || (isList && !countType)) {
    throw new ModelError(`${name} is damaged: its header has a value of unknown kind (${words.slice(1).join(' ')}).`);
  }
  return { name: words[isList ? 4 : 2] ?? '', type, ...(countType && { countType }) };
}
