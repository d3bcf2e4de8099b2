import { LAST_PNG_FILTER, PNG_SIGNATURE, PNG_SAMPLES as SAMPLES, unfilter } from './pngFormat.js';

/** An image in memory. */
export interface Pixels {
  width: number;
  height: number;
  /** 1 for grey, 3 for RGB. */
  channels: 1 | 3;
  /** width·height·channels bytes, top row first. */
  data: Uint8Array;
}

const PALETTE = 3;

/** Compressed bytes inflated at once. A byte may expand to a thousand bytes. */
const PIECE = 1 << 14;

/** The header of a PNG file. */
interface Header {
  width: number;
  height: number;
  /** Bits per sample. */
  depth: number;
  colorType: number;
}

/**
 * Decodes a PNG file of any kind except interlaced ones. Sixteen bits become eight; transparent pixels are blended onto white.
 *
 * An image element with a canvas would convert colours by profiles, round transparent pixels and, in some browsers, add noise against
 * fingerprinting; a map is data and must be read exactly.
 *
 * @param maxSide the longest side that is accepted, in pixels
 * @throws Error whose message continues a sentence that begins with the file's name
 */
export async function decodePng(file: Uint8Array, maxSide: number): Promise<Pixels> {
  if (!PNG_SIGNATURE.every((byte, i) => file[i] === byte)) throw new Error('is not a PNG image; save it as PNG');
  let header: Header | undefined;
  let palette = new Uint8Array();
  let transparency = new Uint8Array();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  for (const { type, data } of chunksOf(file)) {
    if (type === 'IHDR') header = readHeader(data, maxSide);
    else if (type === 'PLTE') palette = data;
    else if (type === 'tRNS') transparency = data;
    else if (type === 'IDAT') parts.push(data);
  }
  if (!header || parts.length === 0) throw new Error(DAMAGED);
  const { width, height, colorType } = header;
  const samples = unpackSamples(await inflate(parts, header), header);
  const onWhite = (grey: number, alpha: number): number => Math.round((grey * alpha) / 255 + 255 - alpha);
  const isGrey = colorType === 0 || colorType === 4;
  const data = new Uint8Array(width * height * (isGrey ? 1 : 3));
  if (isGrey) {
    const step = SAMPLES[colorType];
    for (let i = 0; i < data.length; i++) {
      data[i] = step === 1 ? samples[i] : onWhite(samples[2 * i], samples[2 * i + 1]);
    }
  } else {
    for (let i = 0; i < width * height; i++) {
      const entry = samples[i];
      for (let c = 0; c < 3; c++) {
        data[3 * i + c] =
          colorType === PALETTE
            ? onWhite(palette[3 * entry + c] ?? 0, transparency[entry] ?? 255)
            : colorType === 2
              ? samples[3 * i + c]
              : onWhite(samples[4 * i + c], samples[4 * i + 3]);
      }
    }
  }
  return { width, height, channels: isGrey ? 1 : 3, data };
}

const DAMAGED = 'is a damaged PNG image; save it again';

function* chunksOf(file: Uint8Array): Generator<{ type: string; data: Uint8Array<ArrayBuffer> }> {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  for (let at = PNG_SIGNATURE.length; at + 8 <= file.length; ) {
    const length = view.getUint32(at);
    if (at + 12 + length > file.length) throw new Error(DAMAGED);
    yield {
      type: String.fromCharCode(...file.subarray(at + 4, at + 8)),
      data: file.subarray(at + 8, at + 8 + length) as Uint8Array<ArrayBuffer>,
    };
    at += 12 + length;
  }
}

function readHeader(data: Uint8Array, maxSide: number): Header {
  if (data.length < 13) throw new Error(DAMAGED);
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const [width, height] = [view.getUint32(0), view.getUint32(4)];
  const [depth, colorType, , , interlace] = data.subarray(8);
  if (Math.max(width, height) > maxSide) {
    throw new Error(`has ${width} × ${height} pixels, but at most ${maxSide} per side are allowed`);
  }
  if (width === 0 || height === 0 || SAMPLES[colorType] === undefined || ![1, 2, 4, 8, 16].includes(depth)) {
    throw new Error(DAMAGED);
  }
  if (interlace !== 0) throw new Error('is an interlaced PNG image; save it without interlacing');
  return { width, height, depth, colorType };
}

/** The number of bytes per row, without the byte of its filter. */
const strideOf = ({ width, depth, colorType }: Header): number => Math.ceil((width * SAMPLES[colorType] * depth) / 8);

/** Inflates the bytes of the image, and fails if there are more: a small file can expand to gigabytes. */
async function inflate(parts: Uint8Array<ArrayBuffer>[], header: Header): Promise<Uint8Array> {
  const bytes = new Uint8Array(header.height * (strideOf(header) + 1));
  const pieces = piecesOf(parts);
  const compressed = new ReadableStream<Uint8Array<ArrayBuffer>>({
    pull(controller) {
      const { done, value } = pieces.next();
      if (done) controller.close();
      else controller.enqueue(value);
    },
  });
  const reader = compressed.pipeThrough(new DecompressionStream('deflate')).getReader();
  let filled = 0;
  for (;;) {
    const { done, value } = await reader.read().catch(() => {
      throw new Error(DAMAGED);
    });
    if (done) break;
    if (filled + value.length > bytes.length) {
      reader.cancel().catch(() => {});
      throw new Error(
        `holds more data than its ${header.width} × ${header.height} pixels need, and was not read; save it again`,
      );
    }
    bytes.set(value, filled);
    filled += value.length;
  }
  if (filled < bytes.length) throw new Error(DAMAGED);
  return bytes;
}

function* piecesOf(parts: Uint8Array<ArrayBuffer>[]): Generator<Uint8Array<ArrayBuffer>> {
  for (const part of parts) {
    for (let at = 0; at < part.length; at += PIECE) yield part.subarray(at, at + PIECE);
  }
}

/** Undoes the row filters and converts samples of any depth to eight bits; palette indices stay as they are. */
function unpackSamples(bytes: Uint8Array, header: Header): Uint8Array {
  const { width, height, depth, colorType } = header;
  const samplesPerRow = width * SAMPLES[colorType];
  const stride = strideOf(header);
  const pixelBytes = Math.max(1, (SAMPLES[colorType] * depth) / 8);
  const samples = new Uint8Array(samplesPerRow * height);
  const scale = colorType === PALETTE || depth >= 8 ? 1 : 255 / (2 ** depth - 1);
  let above: Uint8Array = new Uint8Array(stride);
  for (let row = 0; row < height; row++) {
    const start = row * (stride + 1);
    const line = bytes.subarray(start + 1, start + 1 + stride);
    if (bytes[start] > LAST_PNG_FILTER) throw new Error(DAMAGED);
    unfilter(line, above, pixelBytes, bytes[start]);
    for (let i = 0; i < samplesPerRow; i++) {
      const at = i * depth;
      const sample = depth >= 8 ? line[at >> 3] : (line[at >> 3] >> (8 - depth - (at & 7))) & (2 ** depth - 1);
      samples[row * samplesPerRow + i] = sample * scale;
    }
    above = line;
  }
  return samples;
}
