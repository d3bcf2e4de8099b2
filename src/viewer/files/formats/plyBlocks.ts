import type { GrowingIndices } from './GrowingIndices.js';
import { PLY_BYTES, type PlyElement, type PlyProperty, type PlyType } from './plyHeader.js';
import type { BinaryNumbers } from './plyRows.js';

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
  const rowBytes = properties.reduce((sum, { type }) => sum + PLY_BYTES[type], 0);
  if (count * rowBytes > numbers.bytesLeft) return false;
  let offset = numbers.at;
  for (const property of properties) {
    for (const column of columns)
      if (column.property === property) readColumn(numbers, offset, rowBytes, count, column);
    offset += PLY_BYTES[property.type];
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
    const read = GETTERS[property.type];
    for (let at = start, to = axis; at < end; at += rowBytes, to += step) target[to] = read(view, at, isLittle);
  }
}

const GETTERS: Readonly<Record<PlyType, (view: DataView, at: number, isLittle: boolean) => number>> = {
  int8: (view, at) => view.getInt8(at),
  uint8: (view, at) => view.getUint8(at),
  int16: (view, at, isLittle) => view.getInt16(at, isLittle),
  uint16: (view, at, isLittle) => view.getUint16(at, isLittle),
  int32: (view, at, isLittle) => view.getInt32(at, isLittle),
  uint32: (view, at, isLittle) => view.getUint32(at, isLittle),
  float32: (view, at, isLittle) => view.getFloat32(at, isLittle),
  float64: (view, at, isLittle) => view.getFloat64(at, isLittle),
};

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
  if (properties.length !== 1 || countType !== 'uint8' || PLY_BYTES[type] !== 4 || type === 'float32') return 0;
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
