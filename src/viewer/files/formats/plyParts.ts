import { AsciiReader } from '../common/AsciiReader.js';
import { ModelError } from '../common/ModelError.js';
import type { GrowingIndices } from './GrowingIndices.js';

/** A number type of PLY. */
type PlyType = 'int8' | 'uint8' | 'int16' | 'uint16' | 'int32' | 'uint32' | 'float32' | 'float64';

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

/** Reads a number of a binary file. */
type Read = (view: DataView, at: number, isLittle: boolean) => number;

/** Size of each type in a binary file, in bytes, and how it is read. */
const BINARY: Readonly<Record<PlyType, { bytes: number; read: Read }>> = {
  int8: { bytes: 1, read: (view, at) => view.getInt8(at) },
  uint8: { bytes: 1, read: (view, at) => view.getUint8(at) },
  int16: { bytes: 2, read: (view, at, isLittle) => view.getInt16(at, isLittle) },
  uint16: { bytes: 2, read: (view, at, isLittle) => view.getUint16(at, isLittle) },
  int32: { bytes: 4, read: (view, at, isLittle) => view.getInt32(at, isLittle) },
  uint32: { bytes: 4, read: (view, at, isLittle) => view.getUint32(at, isLittle) },
  float32: { bytes: 4, read: (view, at, isLittle) => view.getFloat32(at, isLittle) },
  float64: { bytes: 8, read: (view, at, isLittle) => view.getFloat64(at, isLittle) },
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

/** Words that begin a line without data. The format allows such lines only in the header, but some programs write them between rows. */
const COMMENTS = ['comment', 'obj_info', '#'];

/** Reads the numbers of a PLY file one at a time. */
export interface PlyNumbers {
  /** Call this before each row. */
  startRow(): void;
  next(type: PlyType): number;
  /** The number of bytes left. */
  readonly bytesLeft: number;
}

/** Creates the reader of the numbers after the header. */
export function plyNumbers(bytes: Uint8Array, { format, end }: PlyHeader): PlyNumbers {
  return format === 'ascii' ? new AsciiNumbers(bytes, end) : new BinaryNumbers(bytes, end, format === 'little');
}

/** The minimum size of a row, in bytes. */
export function leastRowBytes({ properties }: PlyElement, format: PlyHeader['format']): number {
  // A number takes at least a digit and a space.
  if (format === 'ascii') return 2 * properties.length;
  return properties.reduce((sum, { type, countType }) => sum + BINARY[countType ?? type].bytes, 0);
}

class AsciiNumbers implements PlyNumbers {
  private readonly reader: AsciiReader;

  constructor(bytes: Uint8Array, at: number) {
    this.reader = new AsciiReader(bytes, at);
  }

  startRow(): void {
    while (COMMENTS.some((comment) => this.reader.isAt(comment))) this.reader.skipLine();
  }

  next(): number {
    return this.reader.number();
  }

  get bytesLeft(): number {
    return this.reader.isAtEnd ? 0 : this.reader.bytesLeft;
  }
}

/** Reads the numbers of a binary file. */
export class BinaryNumbers implements PlyNumbers {
  readonly view: DataView;

  /** @param at byte offset of the first number */
  constructor(
    bytes: Uint8Array,
    public at: number,
    readonly isLittle: boolean,
  ) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  startRow(): void {}

  get bytesLeft(): number {
    return Math.max(this.view.byteLength - this.at, 0);
  }

  /** Reads the next number; NaN at the end of the file. */
  next(type: PlyType): number {
    const { view, at, isLittle } = this;
    this.at += BINARY[type].bytes;
    return this.at > view.byteLength ? NaN : BINARY[type].read(view, at, isLittle);
  }
}

/** The target of a property's numbers: every `step`th entry of an array, from `axis` on. */
export interface PlyColumn {
  property: PlyProperty;
  target: Float32Array | Float64Array;
  axis: number;
  step: number;
}

/**
 * Reads a binary element with rows of equal length column by column, which is several times as fast as number by number. All rows must be
 * present. Unwanted columns are skipped.
 *
 * @returns false if a row contains a list, which prevents this
 */
export function readColumns({ count, properties }: PlyElement, numbers: BinaryNumbers, columns: PlyColumn[]): boolean {
  if (properties.some(({ countType }) => countType)) return false;
  const rowBytes = properties.reduce((sum, { type }) => sum + BINARY[type].bytes, 0);
  if (count * rowBytes > numbers.bytesLeft) return false;
  let offset = numbers.at;
  for (const property of properties) {
    for (const column of columns)
      if (column.property === property) readColumn(numbers, offset, rowBytes, count, column);
    offset += BINARY[property.type].bytes;
  }
  numbers.at += count * rowBytes;
  return true;
}

function readColumn(
  { view, isLittle }: BinaryNumbers,
  start: number,
  rowBytes: number,
  count: number,
  { property, target, axis, step }: PlyColumn,
): void {
  const end = start + count * rowBytes;
  // The type is tested once, not per number.
  if (property.type === 'float32') {
    for (let at = start, to = axis; at < end; at += rowBytes, to += step) target[to] = view.getFloat32(at, isLittle);
  } else if (property.type === 'uint8') {
    for (let at = start, to = axis; at < end; at += rowBytes, to += step) target[to] = view.getUint8(at);
  } else {
    const { read } = BINARY[property.type];
    for (let at = start, to = axis; at < end; at += rowBytes, to += step) target[to] = read(view, at, isLittle);
  }
}

/**
 * Reads the faces of a binary element that contains only lists of corners, as most programs write it, up to the first face that is not a
 * triangle.
 *
 * @returns the number of faces read; the caller reads the others
 */
export function readTriangles(
  { count, properties }: PlyElement,
  numbers: BinaryNumbers,
  indices: GrowingIndices,
): number {
  const [{ type, countType }] = properties;
  if (properties.length !== 1 || countType !== 'uint8' || BINARY[type].bytes !== 4 || type === 'float32') return 0;
  const { view, isLittle } = numbers;
  const faces = Math.min(count, Math.floor(numbers.bytesLeft / ROW_BYTES));
  indices.reserve(3 * faces);
  let { at } = numbers;
  let face = 0;
  // A negative index wraps to the same large index as in the reader of single numbers.
  for (; face < faces && view.getUint8(at) === 3; face++, at += ROW_BYTES) {
    indices.add(view.getUint32(at + 1, isLittle), view.getUint32(at + 5, isLittle), view.getUint32(at + 9, isLittle));
  }
  numbers.at = at;
  return face;
}

/** The bytes of a triangle: a count and three indices. */
const ROW_BYTES = 13;
