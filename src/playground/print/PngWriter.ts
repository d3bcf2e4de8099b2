import { PNG_COLOR_TYPE, PNG_SIGNATURE, pngChunk, pngHeader } from '../../strokes/mapFiles/pngFormat.js';

const INCHES_PER_METRE = 1 / 0.0254;
/** The Up filter stores differences to the row above. Rows of plain paper become zeros. */
const UP = 2;
/** Compressed bytes per chunk. */
const CHUNK_BYTES = 1 << 18;

export interface PngHeader {
  width: number;
  height: number;
  /** Three for RGB; four with straight alpha. */
  channels: 3 | 4;
  /** Dots per inch, which give the size in print. */
  dpi: number;
}

/**
 * Writes a PNG row by row, so that a picture of any size takes little memory: `rows` resolves when more can be written. Colours are sRGB.
 */
export class PngWriter {
  private readonly compression = new CompressionStream('deflate');
  private readonly input = this.compression.writable.getWriter();
  private readonly output: Promise<void>;
  private readonly before: Uint8Array;

  /** @param write receives the parts of the file, in order */
  constructor(
    { width, height, channels, dpi }: PngHeader,
    private readonly write: (part: Uint8Array<ArrayBuffer>) => void,
  ) {
    this.before = new Uint8Array(width * channels);
    write(PNG_SIGNATURE);
    write(pngHeader(width, height, 8, channels === 4 ? PNG_COLOR_TYPE.rgba : PNG_COLOR_TYPE.rgb));
    write(pngChunk('sRGB', Uint8Array.of(0)));
    write(pngChunk('pHYs', physicalSize(dpi)));
    this.output = this.writeCompressed();
    // Marks the rejection as handled; writing rows or the end rejects with it.
    this.output.catch(() => {});
  }

  /** Writes the next rows, from the top. The array may be reused at once. */
  async rows(pixels: Uint8Array): Promise<void> {
    const { before } = this;
    const length = before.length;
    const count = pixels.length / length;
    const filtered = new Uint8Array(count * (length + 1));
    for (let row = 0; row < count; row++) {
      const from = row * length;
      const to = row * (length + 1);
      filtered[to] = UP;
      for (let i = 0; i < length; i++) {
        const value = pixels[from + i];
        filtered[to + 1 + i] = value - before[i];
        before[i] = value;
      }
    }
    await this.input.write(filtered);
    await this.input.ready;
  }

  /** Resolves when the whole file is written. */
  async end(): Promise<void> {
    await this.input.close();
    await this.output;
    this.write(pngChunk('IEND'));
  }

  /** Stops and frees the memory. The file stays incomplete. */
  async abort(): Promise<void> {
    await this.input.abort().catch(() => {});
    await this.output.catch(() => {});
  }

  private async writeCompressed(): Promise<void> {
    const reader = this.compression.readable.getReader();
    let parts: Uint8Array[] = [];
    let length = 0;
    const flush = (): void => {
      if (length > 0) this.write(pngChunk('IDAT', joined(parts, length)));
      parts = [];
      length = 0;
    };
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      parts.push(part.value);
      length += part.value.length;
      if (length >= CHUNK_BYTES) flush();
    }
    flush();
  }
}

/** The pHYs data: dots per metre in both directions. */
function physicalSize(dpi: number): Uint8Array {
  const view = new DataView(new ArrayBuffer(9));
  const dotsPerMetre = Math.round(dpi * INCHES_PER_METRE);
  view.setUint32(0, dotsPerMetre);
  view.setUint32(4, dotsPerMetre);
  view.setUint8(8, 1);
  return new Uint8Array(view.buffer);
}

function joined(parts: readonly Uint8Array[], length: number): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
