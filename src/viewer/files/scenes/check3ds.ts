import { ModelError } from '../common/ModelError.js';

const HEADER_BYTES = 6;
/** Chunks that contain chunks: the file, its models, a material, its pictures, a mesh. */
const CONTAINERS = new Set([0x4d4d, 0x3d3d, 0xafff, 0xa200, 0xa204, 0xa210, 0xa230, 0x4100]);
const OBJECT = 0x4000;
const HIDDEN = 0x4010;
const FACES = 0x4120;
const AXES = 0x4160;
const AMBIENT = 0xa010;
/** An id that three's loader skips. */
const UNREAD = 0x3fff;
/** The local axes of a mesh: identity, or with x mirrored. */
const [SAME, MIRRORED] = [1, -1].map((x) => [x, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]);

/**
 * Checks that every chunk of a 3DS file has a length and lies within its parent; three's loader would loop forever on a chunk of length 0.
 * Also hides data in the bytes that the loader misreads: hidden objects, the ambient colour, which it takes for the surface colour, and the
 * axes of meshes, whose points are in world space already. Of the axes only mirroring is kept.
 *
 * @throws ModelError
 */
export function check3ds(bytes: Uint8Array, name: string): void {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const pending = [{ start: 0, end: bytes.length, parent: 0, isObject: false }];
  for (let range = pending.pop(); range; range = pending.pop()) {
    for (let at = range.start; at + HEADER_BYTES <= range.end; ) {
      const id = view.getUint16(at, true);
      const end = at + view.getUint32(at + 2, true);
      if (end < at + HEADER_BYTES || end > range.end) {
        throw new ModelError(`${name} is damaged or cut short: one of its parts has a wrong length.`);
      }
      const start = firstChild(bytes, view, id, at + HEADER_BYTES, end);
      if (start !== undefined) pending.push({ start, end, parent: at, isObject: id === OBJECT });
      if (id === AMBIENT) view.setUint16(at, UNREAD, true);
      else if (id === HIDDEN && range.isObject) view.setUint16(range.parent, UNREAD, true);
      else if (id === AXES) plainAxes(view, at + HEADER_BYTES, end);
      at = end;
    }
  }
}

/** Replaces axes by those of the world. */
function plainAxes(view: DataView, at: number, end: number): void {
  if (at + 4 * SAME.length > end) return;
  const [ax, ay, az, bx, by, bz, cx, cy, cz] = SAME.map((_, i) => view.getFloat32(at + 4 * i, true));
  const turn = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  for (const [i, value] of (turn < 0 ? MIRRORED : SAME).entries()) view.setFloat32(at + 4 * i, value, true);
}

/** The offset of the first chunk within a chunk; undefined if it has none. */
function firstChild(bytes: Uint8Array, view: DataView, id: number, at: number, end: number): number | undefined {
  if (CONTAINERS.has(id)) return at;
  if (id === OBJECT) {
    const nameEnd = bytes.indexOf(0, at);
    return nameEnd === -1 || nameEnd >= end ? undefined : nameEnd + 1;
  }
  return id === FACES && at + 2 <= end ? at + 2 + 8 * view.getUint16(at, true) : undefined;
}
