import { ModelError } from '../common/ModelError.js';

const HEADER_BYTES = 6;
/** Chunks whose content is other chunks: the file, its models, a material, its pictures, a mesh. */
const CONTAINERS = new Set([0x4d4d, 0x3d3d, 0xafff, 0xa200, 0xa204, 0xa210, 0xa230, 0x4100]);
const OBJECT = 0x4000;
const FACES = 0x4120;

/**
 * Checks that every chunk of a 3DS file has a length and lies within the one that holds it. three's loader would read one
 * without a length for ever.
 *
 * @throws ModelError
 */
export function check3ds(bytes: Uint8Array, name: string): void {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const pending = [{ start: 0, end: bytes.length }];
  for (let range = pending.pop(); range; range = pending.pop()) {
    for (let at = range.start; at + HEADER_BYTES <= range.end; ) {
      const id = view.getUint16(at, true);
      const end = at + view.getUint32(at + 2, true);
      if (end < at + HEADER_BYTES || end > range.end) {
        throw new ModelError(`${name} is damaged or cut short: one of its parts has a wrong length.`);
      }
      const start = firstChild(bytes, view, id, at + HEADER_BYTES, end);
      if (start !== undefined) pending.push({ start, end });
      at = end;
    }
  }
}

/** The byte where the chunks within a chunk begin; undefined if it holds none. */
function firstChild(bytes: Uint8Array, view: DataView, id: number, at: number, end: number): number | undefined {
  if (CONTAINERS.has(id)) return at;
  if (id === OBJECT) {
    const nameEnd = bytes.indexOf(0, at);
    return nameEnd === -1 || nameEnd >= end ? undefined : nameEnd + 1;
  }
  return id === FACES && at + 2 <= end ? at + 2 + 8 * view.getUint16(at, true) : undefined;
}
