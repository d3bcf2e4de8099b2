import { PNG } from 'pngjs';
import { describe, expect, test } from 'vitest';
import { imageSize } from '../../../../../src/viewer/files/pictures/imageSize.js';

const bytes = (...parts: (string | number[])[]): Uint8Array => {
  const content = parts.flatMap((part) => (typeof part === 'string' ? [...Buffer.from(part, 'latin1')] : part));
  return Uint8Array.from([...content, ...new Array(40).fill(0)]);
};

describe('the size of a picture', () => {
  test('PNG', () => {
    expect(imageSize(PNG.sync.write(new PNG({ width: 300, height: 7 })))).toEqual([300, 7]);
  });

  test('JPEG: past segments, tables and fill, baseline and progressive', () => {
    const app = [0xff, 0xe0, 0, 4, 1, 2];
    const huffman = [0xff, 0xc4, 0, 3, 9];
    const frame = (kind: number) => [0xff, kind, 0, 11, 8, 0x01, 0x02, 0x03, 0x04, 1, 0, 0, 0];
    for (const kind of [0xc0, 0xc2]) {
      expect(imageSize(bytes([0xff, 0xd8], app, huffman, frame(kind)))).toEqual([0x0304, 0x0102]);
      expect(imageSize(bytes([0xff, 0xd8], app, [0xff, 0xff], frame(kind)))).toEqual([0x0304, 0x0102]);
    }
    expect(imageSize(bytes([0xff, 0xd8], app, [0, 1, 2, 3]))).toBeUndefined();
  });

  test('WebP: lossy, lossless, extended', () => {
    const riff = (kind: string) => `RIFF\0\0\0\0WEBP${kind}`;
    expect(imageSize(bytes(riff('VP8 '), new Array(10).fill(1), [0x20, 0x43, 0x10, 0x82]))).toEqual([0x320, 0x210]);
    // 14 bits each, one less than the size, after the signature byte.
    const lossless = (0x11 - 1) | ((0x222 - 1) << 14);
    expect(
      imageSize(bytes(riff('VP8L'), [0, 0, 0, 0, 0x2f], [...new Uint8Array(Uint32Array.of(lossless).buffer)])),
    ).toEqual([0x11, 0x222]);
    expect(imageSize(bytes(riff('VP8X'), new Array(8).fill(0), [0xff, 0x03, 0, 0x0f, 0x27, 0x01]))).toEqual([
      1024, 0x12710,
    ]);
  });

  test('BMP, also with its rows from the top, and GIF', () => {
    const sizes = (height: number) => [...new Uint8Array(Int32Array.of(300, height).buffer)];
    expect(imageSize(bytes('BM', new Array(16).fill(0), sizes(7)))).toEqual([300, 7]);
    expect(imageSize(bytes('BM', new Array(16).fill(0), sizes(-7)))).toEqual([300, 7]);
    expect(imageSize(bytes('GIF89a', [0x2c, 1, 7, 0]))).toEqual([300, 7]);
  });

  test('nothing else, and nothing cut short', () => {
    expect(imageSize(bytes('GIF89a'))).toBeUndefined();
    expect(imageSize(bytes(`RIFF\0\0\0\0WEBPICCP`))).toBeUndefined();
    expect(imageSize(Uint8Array.of(0xff, 0xd8, 0xff))).toBeUndefined();
    expect(imageSize(new Uint8Array(0))).toBeUndefined();
  });
});
