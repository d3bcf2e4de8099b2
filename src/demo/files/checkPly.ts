import { ModelError } from './ModelError.js';

const BYTES: Record<string, number> = {
  char: 1,
  int8: 1,
  uchar: 1,
  uint8: 1,
  short: 2,
  int16: 2,
  ushort: 2,
  uint16: 2,
  int: 4,
  int32: 4,
  uint: 4,
  uint32: 4,
  float: 4,
  float32: 4,
  double: 8,
  float64: 8,
};

/**
 * Reads the header of a PLY file and rejects what three's loader would misread: points without faces, triangle strips,
 * and binary files that are shorter than their header says.
 *
 * @throws ModelError
 */
export function checkPly(bytes: Uint8Array, name: string): void {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, 65536));
  const end = /end_header\r?\n?/.exec(head);
  if (!end) throw new ModelError(`${name} is cut short: its PLY header has no end.`);
  const lines = head.slice(0, end.index).split(/\r\n|\r|\n/);
  const elements = new Map<string, { count: number; stride: number; hasList: boolean }>();
  let current: { count: number; stride: number; hasList: boolean } | undefined;
  for (const line of lines) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'element') {
      current = { count: Number(words[2]), stride: 0, hasList: false };
      elements.set(words[1] ?? '', current);
    } else if (words[0] === 'property' && current) {
      if (words[1] === 'list') current.hasList = true;
      else current.stride += BYTES[words[1] ?? ''] ?? 0;
    }
  }
  const vertices = elements.get('vertex');
  if (!vertices?.count) throw new ModelError(`${name} holds no points.`);
  if (!elements.get('face')?.count) {
    throw new ModelError(
      elements.has('tristrips')
        ? `${name} stores triangle strips, which this page does not read; save it with plain faces.`
        : `${name} holds points but no triangles; only surfaces can be hatched.`,
    );
  }
  const isBinary = /format\s+binary/.test(head.slice(0, end.index));
  if (isBinary && !vertices.hasList && vertices.count * vertices.stride > bytes.length - end.index) {
    throw new ModelError(
      `${name} is cut short: it announces ${vertices.count.toLocaleString('en')} points and ends before them.`,
    );
  }
}
