import { deflateSync } from 'node:zlib';
import { PNG } from 'pngjs';
import { describe, expect, test } from 'vitest';
import { decodePicture, fitPixels, UndecodedError } from '../../../../src/command/draw/NodeSurroundings.js';
import { PNG_SIGNATURE, pngChunk } from '../../../../src/strokes/mapFiles/pngFormat.js';

/** A picture in which every value differs from its neighbours. */
const picture = (width: number, height: number): Uint8ClampedArray =>
  Uint8ClampedArray.from(
    { length: 4 * width * height },
    (_, i) => (i * 37 + ((i / 4) | 0) * 11 + ((i / 90) | 0) * 53) % 256,
  );

const header = (width: number, height: number, depth: number, type: number, interlaced = 0): Uint8Array => {
  const bytes = new DataView(new ArrayBuffer(13));
  bytes.setUint32(0, width);
  bytes.setUint32(4, height);
  for (const [i, value] of [depth, type, 0, 0, interlaced].entries()) bytes.setUint8(8 + i, value);
  return pngChunk('IHDR', new Uint8Array(bytes.buffer));
};
const file = (...chunks: Uint8Array[]): Uint8Array => Buffer.concat([PNG_SIGNATURE, ...chunks, pngChunk('IEND')]);
const data = (rows: readonly (readonly number[])[]): Uint8Array =>
  pngChunk('IDAT', deflateSync(Uint8Array.from(rows.flatMap((row) => [0, ...row]))));

const whole = (): Uint8Array => {
  const png = new PNG({ width: 23, height: 17 });
  png.data = Buffer.from(picture(23, 17));
  return PNG.sync.write(png);
};

describe('PNG', () => {
  test.each([0, 1, 2, 3, 4, -1])('RGBA with filter %i', async (filterType) => {
    const [width, height] = [23, 17];
    const png = new PNG({ width, height });
    png.data = Buffer.from(picture(width, height));
    const decoded = await decodePicture(PNG.sync.write(png, { filterType }));
    expect([decoded.width, decoded.height]).toEqual([width, height]);
    expect(Buffer.from(decoded.data)).toEqual(png.data);
  });

  test.each([0, 2, 4, 6] as const)('colours of type %i, as another decoder has them', async (colorType) => {
    const png = new PNG({ width: 9, height: 7 });
    png.data = Buffer.from(picture(9, 7));
    const bytes = PNG.sync.write(png, { colorType, inputHasAlpha: true });
    expect(Buffer.from((await decodePicture(bytes)).data)).toEqual(PNG.sync.read(bytes).data);
  });

  test('16 bits to a sample', async () => {
    const bytes = file(header(2, 1, 16, 2), data([[0, 0, 255, 255, 128, 0, 1, 0, 2, 0, 3, 0]]));
    expect([...(await decodePicture(bytes)).data]).toEqual([0, 255, 128, 255, 1, 2, 3, 255]);
  });

  test.each([1, 2, 4])('greys of %i bits, in rows that begin with a byte', async (depth) => {
    const most = 2 ** depth - 1;
    const bytes = file(
      header(3, 2, depth, 0),
      data([[0b11100100], [0]].map((row) => [...row, ...(depth === 4 ? [0] : [])])),
    );
    const first = [...(await decodePicture(bytes)).data].filter((_, i) => i % 4 === 0);
    const samples = depth === 1 ? [1, 1, 1] : depth === 2 ? [3, 2, 1] : [14, 4, 0];
    expect(first).toEqual([...samples.map((value) => Math.round((255 * value) / most)), 0, 0, 0]);
  });

  test('a palette with alpha, and a colour that is transparent', async () => {
    const palette = pngChunk('PLTE', Uint8Array.of(10, 20, 30, 40, 50, 60));
    const indexed = file(header(2, 1, 8, 3), palette, pngChunk('tRNS', Uint8Array.of(7)), data([[1, 0]]));
    expect([...(await decodePicture(indexed)).data]).toEqual([40, 50, 60, 255, 10, 20, 30, 7]);
    const keyed = file(header(2, 1, 8, 0), pngChunk('tRNS', Uint8Array.of(0, 9)), data([[9, 8]]));
    expect([...(await decodePicture(keyed)).data]).toEqual([9, 9, 9, 0, 8, 8, 8, 255]);
  });

  test('interlaced', async () => {
    const [width, height] = [11, 6];
    const grey = (x: number, y: number): number => (x * 20 + y * 41) % 256;
    const passes = [
      [0, 0, 8, 8],
      [4, 0, 8, 8],
      [0, 4, 4, 8],
      [2, 0, 4, 4],
      [0, 2, 2, 4],
      [1, 0, 2, 2],
      [0, 1, 1, 2],
    ];
    const rows = passes.flatMap(([x0, y0, dx, dy]) => {
      const lines: number[][] = [];
      for (let y = y0; y < height; y += dy) {
        const line: number[] = [];
        for (let x = x0; x < width; x += dx) line.push(grey(x, y));
        if (line.length > 0) lines.push(line);
      }
      return lines;
    });
    const decoded = await decodePicture(file(header(width, height, 8, 0, 1), data(rows)));
    const expected = Array.from({ length: width * height }, (_, i) => grey(i % width, Math.floor(i / width)));
    expect([...decoded.data].filter((_, i) => i % 4 === 0)).toEqual(expected);
  });

  test.each([
    ['no header', file(data([[0]]))],
    ['a size of zero', file(header(0, 4, 8, 0), data([[0]]))],
    ['an unknown type', file(header(1, 1, 8, 5), data([[0]]))],
    ['too few rows', file(header(1, 4, 8, 0), data([[0]]))],
    ['an unknown filter', file(header(1, 1, 8, 0), pngChunk('IDAT', deflateSync(Uint8Array.of(9, 0))))],
    ['damaged data', file(header(1, 1, 8, 0), pngChunk('IDAT', Uint8Array.of(1, 2, 3)))],
    ['less data than its size takes', file(header(60_000, 60_000, 8, 6), data([[5]]))],
    ['half of its bytes', whole().subarray(0, 400)],
    ['nothing', new Uint8Array()],
  ])('with %s is damaged', async (_, bytes) => {
    await expect(decodePicture(bytes)).rejects.toThrow();
    // The decoder goes on to work.
    expect((await decodePicture(whole())).width).toBe(23);
  });

  test('damage beside the pixels does not matter', async () => {
    const remark = pngChunk('tEXt', Uint8Array.of(1, 2, 3));
    remark[remark.length - 1] ^= 1;
    const [first, pixels] = [header(1, 1, 8, 0), data([[5, 6, 7, 8]])];
    for (const bytes of [file(first, remark, pixels), Buffer.concat([PNG_SIGNATURE, first, pixels, Buffer.alloc(9)])])
      expect([...(await decodePicture(bytes)).data]).toEqual([5, 5, 5, 255]);
  });
});

/** Red on the upper left, blue on the lower left, and almost white on the right: 16 × 16 pixels. */
const JPEG = Buffer.from(
  '/9j/4AAQSkZJRgABAQAAAQABAAD/2wCEAAMDAwMDAwQEBAQFBQUFBQcHBgYHBwsICQgJCAsRCwwLCwwLEQ8SDw4PEg8bFRMTFRsfGhkaHyYiIiYwLTA+PlQBAwMDAwMDBAQEBAUFBQUFBwcGBgcHCwgJCAkICxELDAsLDAsRDxIPDg8SDxsVExMVGx8aGRofJiIiJjAtMD4+VP/CABEIABAAEAMBEQACEQEDEQH/xAAqAAEBAQAAAAAAAAAAAAAAAAAKBwkBAQEBAAAAAAAAAAAAAAAAAAkGB//aAAwDAQACEAMQAAAAg+RIxt7rpznaRiSRKc9b/8QAFBABAAAAAAAAAAAAAAAAAAAAIP/aAAgBAQABPwAf/8QAFBEBAAAAAAAAAAAAAAAAAAAAIP/aAAgBAgEBPwAf/8QAFBEBAAAAAAAAAAAAAAAAAAAAIP/aAAgBAwEBPwAf/9k=',
  'base64',
);
const WEBP = Buffer.from(
  'UklGRjwAAABXRUJQVlA4TDAAAAAvD8ADABcgEEji2J9yErFgYjR/qAi6xIKJx/yJwuma//gXBAIBwqRJpw4i+h8Kry4=',
  'base64',
);

describe('JPEG and WebP', () => {
  test.each([
    ['JPEG', JPEG, 12],
    ['WebP', WEBP, 0],
  ])('%s has the colours that it was made of', async (_, bytes, most) => {
    const { data, width, height } = await decodePicture(bytes);
    expect([width, height, data.length]).toEqual([16, 16, 1024]);
    for (const [x, y, colour] of [
      [2, 2, [230, 20, 20]],
      [2, 13, [20, 20, 230]],
      [13, 8, [250, 250, 250]],
    ] as const) {
      const pixel = data.subarray(4 * (16 * y + x), 4 * (16 * y + x) + 4);
      for (const k of [0, 1, 2]) expect(Math.abs(pixel[k] - colour[k])).toBeLessThanOrEqual(most);
      expect(pixel[3]).toBe(255);
    }
  });

  test.each([
    ['JPEG', JPEG.subarray(0, 60)],
    ['JPEG', JPEG.subarray(0, JPEG.length - 2)],
    ['JPEG', Buffer.concat([JPEG.subarray(0, 2), Buffer.alloc(400, 7)])],
    ['WebP', WEBP.subarray(0, 30)],
  ])('a damaged %s is an error, and the next one is decoded', async (_, bytes) => {
    await expect(decodePicture(bytes)).rejects.toThrow();
    expect((await decodePicture(JPEG)).width).toBe(16);
    expect((await decodePicture(WEBP)).width).toBe(16);
  });

  test('others are told by their names', async () => {
    await expect(decodePicture(Buffer.from('GIF89a'))).rejects.toEqual(new UndecodedError('GIF'));
    await expect(decodePicture(Buffer.from('BM6'))).rejects.toEqual(new UndecodedError('BMP'));
    // The start of a frame of four colours, after bytes that only fill.
    const inks = [0xff, 0xd8, 0xff, 0xff, 0xc0, 0, 20, 8, 0, 16, 0, 16, 4, ...new Uint8Array(12), 0xff, 0xda, 0, 2];
    await expect(decodePicture(Uint8Array.from(inks))).rejects.toEqual(new UndecodedError('CMYK JPEG'));
  });
});

describe('pictures in the size that is asked for', () => {
  const rows = (values: readonly number[]) => Uint8ClampedArray.from(values.flatMap((value) => [value, 0, 0, 255]));

  test('are averaged and flipped', () => {
    const given = { data: rows([10, 20, 30, 40, 50, 60, 70, 80]), width: 4, height: 2 };
    expect(fitPixels(given, { width: 2, height: 1, flipY: false }).data).toEqual(rows([35, 55]));
    expect(fitPixels(given, { width: 4, height: 2, flipY: true }).data).toEqual(rows([50, 60, 70, 80, 10, 20, 30, 40]));
    expect(fitPixels(given, { width: 4, height: 2, flipY: false }).data).toBe(given.data);
  });
});
