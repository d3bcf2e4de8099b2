import { deflateSync } from 'node:zlib';
import { PNG } from 'pngjs';
import { describe, expect, it, vi } from 'vitest';
import { decodePng } from '../../../../src/strokes/mapFiles/decodePng.js';
import { PNG_COLOR_TYPE, PNG_SIGNATURE, pngChunk, pngHeader } from '../../../../src/strokes/mapFiles/pngFormat.js';
import { encodePng } from '../../../../src/strokes/mapFiles/writeMapFiles.js';
import { random } from '../../../../src/strokes/random.js';

const noise = (length: number): Uint8Array => {
  const next = random(length);
  return Uint8Array.from({ length }, () => 256 * next());
};

/** RGBA pixels that differ in alpha, as another library packs them. */
function rgba(colorType: 0 | 2 | 4 | 6): { file: Buffer; data: Buffer } {
  const png = new PNG({ width: 5, height: 3 });
  png.data = Buffer.from(noise(60));
  if (colorType < 4) for (let i = 3; i < 60; i += 4) png.data[i] = 255;
  if (colorType % 4 === 0) for (let i = 0; i < 60; i += 4) png.data[i + 1] = png.data[i + 2] = png.data[i];
  return { file: PNG.sync.write(png, { colorType, inputColorType: 6, inputHasAlpha: true }), data: png.data };
}

describe('encodePng', () => {
  it.each([1, 3] as const)('writes what another library reads (%i channels)', async (channels) => {
    const data = noise(7 * 4 * channels);
    const {
      width,
      height,
      data: read,
    } = PNG.sync.read(Buffer.from(await encodePng({ width: 7, height: 4, channels, data })));
    expect([width, height]).toEqual([7, 4]);
    for (let i = 0; i < 28; i++) {
      const expected = channels === 1 ? [data[i], data[i], data[i], 255] : [...data.subarray(3 * i, 3 * i + 3), 255];
      expect([...read.subarray(4 * i, 4 * i + 4)]).toEqual(expected);
    }
  });
});

describe('decodePng', () => {
  it.each([1, 3] as const)('reads back what was written (%i channels)', async (channels) => {
    const pixels = { width: 64, height: 64, channels, data: noise(64 * 64 * channels) };
    expect(await decodePng(await encodePng(pixels), 64)).toEqual(pixels);
  });

  it.each([2, 6] as const)('reads the colours of another library, on white paper (colour type %i)', async (type) => {
    const { file, data } = rgba(type);
    const read = await decodePng(file, 100);
    expect([read.width, read.height, read.channels]).toEqual([5, 3, 3]);
    for (let i = 0; i < 15; i++) {
      const alpha = data[4 * i + 3] / 255;
      for (let c = 0; c < 3; c++) {
        expect(Math.abs(read.data[3 * i + c] - (data[4 * i + c] * alpha + 255 * (1 - alpha)))).toBeLessThanOrEqual(
          0.51,
        );
      }
    }
  });

  it.each([0, 4] as const)('reads the greys of another library (colour type %i)', async (type) => {
    const { file, data } = rgba(type);
    const read = await decodePng(file, 100);
    expect(read.channels).toBe(1);
    for (let i = 0; i < 15; i++) {
      const alpha = data[4 * i + 3] / 255;
      expect(Math.abs(read.data[i] - (data[4 * i] * alpha + 255 * (1 - alpha)))).toBeLessThanOrEqual(0.51);
    }
  });

  it.each([0, 1, 2, 3, 4])('undoes filter %i', async (filterType) => {
    const png = new PNG({ width: 16, height: 16 });
    png.data = Buffer.from(noise(1024));
    for (let i = 3; i < 1024; i += 4) png.data[i] = 255;
    const read = await decodePng(PNG.sync.write(png, { filterType, colorType: 2 }), 16);
    expect([...read.data]).toEqual([...png.data].filter((_, i) => i % 4 !== 3));
  });

  it('brings sixteen bits to eight', async () => {
    // 3 × 1 greys: 0x1234, 0xff00, 0x00ff.
    const file = Buffer.from(
      'iVBORw0KGgoAAAANSUhEUgAAAAMAAAABEAAAAABuG5crAAAAD0lEQVR4nGMQMvnPwPAfAAZyAkXWyVqEAAAAAElFTkSuQmCC',
      'base64',
    );
    expect(await decodePng(file, 8)).toEqual({ width: 3, height: 1, channels: 1, data: Uint8Array.of(0x12, 0xff, 0) });
  });

  it.each([
    [1, 0b01100000, [0, 255, 255, 0]],
    [2, 0b00011011, [0, 85, 170, 255]],
  ])('spreads greys of %i bits from black to white', async (bits, row, greys) => {
    const parts = [
      PNG_SIGNATURE,
      pngHeader(4, 1, bits, PNG_COLOR_TYPE.grey),
      pngChunk('IDAT', new Uint8Array(deflateSync(Uint8Array.of(0, row)))),
      pngChunk('IEND'),
    ];
    expect([...(await decodePng(Buffer.concat(parts), 8)).data]).toEqual(greys);
  });

  it('reads a palette of one bit', async () => {
    // 8 × 1 pixels, 0 1 0 1 1 0 0 1, of white and a dark green.
    const file = Buffer.from(
      'iVBORw0KGgoAAAANSUhEUgAAAAgAAAABAQMAAADZzn0AAAAABlBMVEX///8AZABUU33dAAAACklEQVR4nGOIBAAAWwBafKWTVAAAAABJRU5ErkJggg==',
      'base64',
    );
    const { data } = await decodePng(file, 8);
    expect([...data.filter((_, i) => i % 3 === 0)]).toEqual([255, 0, 255, 0, 0, 255, 255, 0]);
  });

  it.each<[string, (file: Buffer) => Uint8Array, RegExp]>([
    ['a JPEG', () => Uint8Array.of(0xff, 0xd8, 0xff), /is not a PNG image; save it as PNG/],
    ['nothing', () => new Uint8Array(), /is not a PNG image/],
    ['half a file', (file) => file.subarray(0, file.length >> 1), /is a damaged PNG image/],
    ['a header alone', (file) => file.subarray(0, 33), /is a damaged PNG image/],
    ['broken data', (file) => file.fill(7, 45, 60), /is a damaged PNG image/],
    [
      'an interlaced image',
      (file) => {
        file[28] = 1;
        return file;
      },
      /is an interlaced PNG image; save it without interlacing/,
    ],
    [
      'too large an image',
      (file) => {
        file[17] = 1;
        return file;
      },
      /has 65\d+ × 3 pixels, but at most 100 per side/,
    ],
  ])('refuses %s', async (_, spoil, message) => {
    await expect(decodePng(spoil(rgba(6).file), 100)).rejects.toThrow(message);
  });

  it('stops inflating at the end of the image, however large the file', async () => {
    const sound = Buffer.from(await encodePng({ width: 64, height: 64, channels: 1, data: new Uint8Array(64 * 64) }));
    // 200 MB of zeros in the place of 4 kB, as 200 kB.
    const flood = deflateSync(Buffer.alloc(2e8));
    const chunk = Buffer.alloc(12 + flood.length);
    chunk.writeUInt32BE(flood.length);
    chunk.write('IDAT', 4, 'latin1');
    flood.copy(chunk, 8);
    const file = Buffer.concat([sound.subarray(0, 33), chunk, sound.subarray(-12)]);

    let inflated = 0;
    const Native = DecompressionStream;
    vi.stubGlobal('DecompressionStream', function (this: unknown, format: 'deflate') {
      const { writable, readable } = new Native(format);
      const count = new TransformStream<Uint8Array, Uint8Array>({
        transform(bytes, controller) {
          inflated += bytes.length;
          controller.enqueue(bytes);
        },
      });
      return { writable, readable: readable.pipeThrough(count) };
    });
    await expect(decodePng(file, 100)).rejects.toThrow(/holds more data than its 64 × 64 pixels need.*save it again/);
    // What one piece of the file holds may be on its way.
    expect(inflated).toBeLessThan(4e7);
    vi.unstubAllGlobals();
  });
});
