import { deflateSync } from 'node:zlib';
import { PNG } from 'pngjs';
import { describe, expect, test } from 'vitest';
import { decodePng } from '../../../../src/command/draw/decodePng.js';
import { fitPixels } from '../../../../src/command/draw/fitPixels.js';
import { PNG_SIGNATURE, pngChunk } from '../../../../src/mapFiles/pngChunks.js';

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

describe('PNG', () => {
  test.each([0, 1, 2, 3, 4, -1])('RGBA with filter %i', (filterType) => {
    const [width, height] = [23, 17];
    const png = new PNG({ width, height });
    png.data = Buffer.from(picture(width, height));
    const decoded = decodePng(PNG.sync.write(png, { filterType }));
    expect([decoded.width, decoded.height]).toEqual([width, height]);
    expect(Buffer.from(decoded.data)).toEqual(png.data);
  });

  test.each([0, 2, 4, 6] as const)('colours of type %i, as another decoder has them', (colorType) => {
    const png = new PNG({ width: 9, height: 7 });
    png.data = Buffer.from(picture(9, 7));
    const bytes = PNG.sync.write(png, { colorType, inputHasAlpha: true });
    expect(Buffer.from(decodePng(bytes).data)).toEqual(PNG.sync.read(bytes).data);
  });

  test('16 bits to a sample', () => {
    const bytes = file(header(2, 1, 16, 2), data([[0, 0, 255, 255, 128, 0, 1, 0, 2, 0, 3, 0]]));
    expect([...decodePng(bytes).data]).toEqual([0, 255, 128, 255, 1, 2, 3, 255]);
  });

  test.each([1, 2, 4])('greys of %i bits, in rows that begin with a byte', (depth) => {
    const most = 2 ** depth - 1;
    const bytes = file(
      header(3, 2, depth, 0),
      data([[0b11100100], [0]].map((row) => [...row, ...(depth === 4 ? [0] : [])])),
    );
    const first = [...decodePng(bytes).data].filter((_, i) => i % 4 === 0);
    const samples = depth === 1 ? [1, 1, 1] : depth === 2 ? [3, 2, 1] : [14, 4, 0];
    expect(first).toEqual([...samples.map((value) => Math.round((255 * value) / most)), 0, 0, 0]);
  });

  test('a palette with alpha, and a colour that is transparent', () => {
    const palette = pngChunk('PLTE', Uint8Array.of(10, 20, 30, 40, 50, 60));
    const indexed = file(header(2, 1, 8, 3), palette, pngChunk('tRNS', Uint8Array.of(7)), data([[1, 0]]));
    expect([...decodePng(indexed).data]).toEqual([40, 50, 60, 255, 10, 20, 30, 7]);
    const keyed = file(header(2, 1, 8, 0), pngChunk('tRNS', Uint8Array.of(0, 9)), data([[9, 8]]));
    expect([...decodePng(keyed).data]).toEqual([9, 9, 9, 0, 8, 8, 8, 255]);
  });

  test('interlaced', () => {
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
    const decoded = decodePng(file(header(width, height, 8, 0, 1), data(rows)));
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
    // It would be 4 GB.
    ['more data than its size takes', file(header(1, 1, 8, 0), pngChunk('IDAT', deflateSync(new Uint8Array(1000))))],
    ['nothing', new Uint8Array()],
  ])('with %s is damaged', (_, bytes) => {
    expect(() => decodePng(bytes)).toThrow();
  });
});

describe('pictures in the size that is asked for', () => {
  const rows = (values: readonly number[]) => Uint8ClampedArray.from(values.flatMap((value) => [value, 0, 0, 255]));

  test('are the means of their pixels, and turned over', () => {
    const given = { data: rows([10, 20, 30, 40, 50, 60, 70, 80]), width: 4, height: 2 };
    expect(fitPixels(given, { width: 2, height: 1, flipY: false }).data).toEqual(rows([35, 55]));
    expect(fitPixels(given, { width: 4, height: 2, flipY: true }).data).toEqual(rows([50, 60, 70, 80, 10, 20, 30, 40]));
    expect(fitPixels(given, { width: 4, height: 2, flipY: false }).data).toBe(given.data);
  });
});
