import { expect, test } from 'vitest';
import { crc32, pngChunk } from '../../../../src/strokes/mapFiles/pngFormat.js';

test('the checksum is that of the standard', () => {
  expect(crc32(Buffer.from('123456789'))).toBe(0xcbf43926);
});

test('a chunk has the length of its content, its type, the content and their checksum', () => {
  // The chunk that ends every PNG file.
  expect(Buffer.from(pngChunk('IEND')).toString('hex')).toBe('0000000049454e44ae426082');
  expect(Buffer.from(pngChunk('sRGB', Uint8Array.of(0))).toString('hex')).toBe('000000017352474200aece1ce9');
});
