import { AsciiReader } from '../common/AsciiReader.js';
import { PLY_BYTES, type PlyElement, type PlyHeader, type PlyType } from './plyHeader.js';

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
  return properties.reduce((sum, { type, countType }) => sum + PLY_BYTES[countType ?? type], 0);
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
    this.at += PLY_BYTES[type];
    if (this.at > view.byteLength) return NaN;
    switch (type) {
      case 'int8':
        return view.getInt8(at);
      case 'uint8':
        return view.getUint8(at);
      case 'int16':
        return view.getInt16(at, isLittle);
      case 'uint16':
        return view.getUint16(at, isLittle);
      case 'int32':
        return view.getInt32(at, isLittle);
      case 'uint32':
        return view.getUint32(at, isLittle);
      case 'float32':
        return view.getFloat32(at, isLittle);
      default:
        return view.getFloat64(at, isLittle);
    }
  }
}
