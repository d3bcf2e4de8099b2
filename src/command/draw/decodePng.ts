import { inflateSync } from 'node:zlib';
import { LAST_PNG_FILTER, PNG_SAMPLES as SAMPLES, unfilter } from '../../strokes/mapFiles/pngFormat.js';
import type { PixelPicture } from '../../viewer/files/common/Surroundings.js';

const PALETTE = 3;
/** The seven passes of Adam7 interlacing: where each begins, and its steps. */
const PASSES = [
  [0, 0, 8, 8],
  [4, 0, 8, 8],
  [0, 4, 4, 8],
  [2, 0, 4, 4],
  [0, 2, 2, 4],
  [1, 0, 2, 2],
  [0, 1, 1, 2],
] as const;
const WHOLE = [[0, 0, 1, 1]] as const;
/** Sizes of the signature and of the parts of chunks. */
const SIGNATURE_BYTES = 8;
const CHUNK_BYTES = 12;

interface Header {
  width: number;
  height: number;
  /** Bits per sample. */
  depth: number;
  type: number;
  isInterlaced: boolean;
}

/** The parts of a PNG file after its header that decoding needs. */
interface Content {
  header: Header;
  data: Uint8Array;
  /** RGB of each palette index. */
  palette: Uint8Array;
  /** The tRNS chunk: alpha per palette index, or the transparent grey or colour. */
  transparency: Uint8Array;
}

/**
 * Decodes a PNG picture of any colour type, depth and interlacing. Checksums of chunks are not checked.
 *
 * @throws Error if it is damaged
 */
export function decodePng(bytes: Uint8Array): Omit<PixelPicture, 'close'> {
  const content = readChunks(bytes);
  const { width, height, depth, type, isInterlaced } = content.header;
  const samples = SAMPLES[type];
  if (!samples || ![1, 2, 4, 8, 16].includes(depth) || width * height === 0) throw new Error('PNG: damaged header');
  const passes = (isInterlaced ? PASSES : WHOLE).map(([x, y, dx, dy]) => {
    const columns = Math.ceil((width - x) / dx);
    const rows = Math.ceil((height - y) / dy);
    const rowBytes = columns > 0 && rows > 0 ? Math.ceil((columns * samples * depth) / 8) : 0;
    return { x, y, dx, dy, columns, rows: rowBytes > 0 ? rows : 0, rowBytes };
  });
  const size = passes.reduce((sum, { rows, rowBytes }) => sum + rows * (rowBytes + 1), 0);
  const rows = inflateSync(content.data, { maxOutputLength: size + 1 });
  if (rows.length < size) throw new Error('PNG: cut short');
  const data = new Uint8ClampedArray(4 * width * height);
  const write = pixelWriter(content);
  const step = Math.max(1, (samples * depth) / 8);
  let at = 0;
  for (const pass of passes) {
    let above = new Uint8Array(pass.rowBytes);
    for (let row = 0; row < pass.rows; row++) {
      const line = rows.subarray(at + 1, at + 1 + pass.rowBytes);
      if (rows[at] > LAST_PNG_FILTER) throw new Error('PNG: unknown filter');
      unfilter(line, above, step, rows[at]);
      const y = pass.y + row * pass.dy;
      for (let column = 0; column < pass.columns; column++)
        write(line, column, data, 4 * (y * width + pass.x + column * pass.dx));
      above = line;
      at += pass.rowBytes + 1;
    }
  }
  return { data, width, height };
}

function readChunks(bytes: Uint8Array): Content {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const parts: Uint8Array[] = [];
  const found = new Map<string, Uint8Array>();
  for (let at = SIGNATURE_BYTES; at + CHUNK_BYTES <= bytes.length; ) {
    const length = view.getUint32(at);
    const name = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    const content = bytes.subarray(at + 8, at + 8 + length);
    if (name === 'IDAT') parts.push(content);
    else found.set(name, content);
    at += CHUNK_BYTES + length;
  }
  const header = found.get('IHDR');
  if (!header || header.length < 13) throw new Error('PNG: no header');
  const fields = new DataView(header.buffer, header.byteOffset, header.length);
  return {
    header: {
      width: fields.getUint32(0),
      height: fields.getUint32(4),
      depth: header[8],
      type: header[9],
      isInterlaced: header[12] === 1,
    },
    data: Buffer.concat(parts),
    palette: found.get('PLTE') ?? new Uint8Array(),
    transparency: found.get('tRNS') ?? new Uint8Array(),
  };
}

type WritePixel = (line: Uint8Array, column: number, data: Uint8ClampedArray, at: number) => void;

/** Returns the function that writes one pixel of a row as RGBA. */
function pixelWriter({ header: { depth, type }, palette, transparency }: Content): WritePixel {
  const samples = SAMPLES[type];
  const most = 2 ** depth - 1;
  const isClear = transparency.length >= 2 * samples && type !== PALETTE && samples % 2 === 1;
  const clear = Array.from({ length: samples }, (_, k) => (transparency[2 * k] << 8) | transparency[2 * k + 1]);
  const sample = (line: Uint8Array, i: number): number => {
    if (depth === 8) return line[i];
    if (depth === 16) return (line[2 * i] << 8) | line[2 * i + 1];
    const bit = i * depth;
    return (line[bit >> 3] >> (8 - depth - (bit & 7))) & most;
  };
  return (line, column, data, at) => {
    if (type === PALETTE) {
      const index = sample(line, column);
      for (let k = 0; k < 3; k++) data[at + k] = palette[3 * index + k] ?? 0;
      data[at + 3] = transparency[index] ?? 255;
      return;
    }
    const first = column * samples;
    const grey = samples < 3;
    for (let k = 0; k < 3; k++) data[at + k] = Math.round((255 * sample(line, first + (grey ? 0 : k))) / most);
    if (samples % 2 === 0) data[at + 3] = Math.round((255 * sample(line, first + samples - 1)) / most);
    else data[at + 3] = isClear && clear.every((value, k) => value === sample(line, first + k)) ? 0 : 255;
  };
}
