import { crc32 } from 'node:zlib';
import { PNG } from 'pngjs';
import { describe, expect, test } from 'vitest';
import { BlobWriter } from '../../../../src/playground/export/zip.js';
import { PngWriter } from '../../../../src/playground/print/PngWriter.js';

/** Every chunk of a PNG, its checksum checked. */
function chunksOf(file: Buffer): Map<string, Buffer> {
  const chunks = new Map<string, Buffer>();
  for (let at = 8; at < file.length; ) {
    const length = file.readUInt32BE(at);
    const type = file.toString('latin1', at + 4, at + 8);
    const content = file.subarray(at + 8, at + 8 + length);
    expect(file.readUInt32BE(at + 8 + length)).toBe(crc32(file.subarray(at + 4, at + 8 + length)));
    chunks.set(type, content);
    at += length + 12;
  }
  return chunks;
}

describe('PngWriter', () => {
  test.each([3, 4] as const)('writes what it was given, with %i channels, and its size in print', async (channels) => {
    const [width, height] = [37, 23];
    const pixels = Uint8Array.from({ length: width * height * channels }, (_, i) => (i * 7919) >> 3);
    const blob = new BlobWriter();
    const png = new PngWriter({ width, height, channels, dpi: 600 }, blob.write);
    const row = width * channels;
    for (const [from, to] of [
      [0, 1],
      [1, 9],
      [9, 23],
    ]) {
      const rows = pixels.slice(from * row, to * row);
      await png.rows(rows);
      rows.fill(0);
    }
    await png.end();
    const file = Buffer.from(await blob.end('image/png').arrayBuffer());
    const read = PNG.sync.read(file);
    expect([read.width, read.height]).toEqual([width, height]);
    for (let i = 0; i < width * height; i++) {
      const given = [...pixels.subarray(i * channels, (i + 1) * channels), 255].slice(0, 4);
      expect([...read.data.subarray(4 * i, 4 * i + 4)]).toEqual(given);
    }
    const physical = chunksOf(file).get('pHYs')!;
    expect([physical.readUInt32BE(0), physical.readUInt32BE(4), physical[8]]).toEqual([23622, 23622, 1]);
    expect([...chunksOf(file).keys()]).toEqual(['IHDR', 'sRGB', 'pHYs', 'IDAT', 'IEND']);
  });

  test('an A2 sheet of flat paper takes little, and can be stopped', async () => {
    const width = 9921;
    let bytes = 0;
    const header = { width, height: 2000, channels: 3, dpi: 600 } as const;
    const png = new PngWriter(header, (part) => {
      bytes += part.length;
    });
    const band = new Uint8Array(width * 3 * 100).fill(247);
    for (let i = 0; i < 5; i++) await png.rows(band);
    await png.abort();
    const before = bytes;
    // By the time that another sheet is written, what is left of this one would be, too.
    const other = new PngWriter(header, () => {});
    for (let i = 0; i < 5; i++) await other.rows(band);
    await other.end();
    expect(bytes).toBe(before);
    expect(bytes).toBeLessThan(100_000);
  });
});
