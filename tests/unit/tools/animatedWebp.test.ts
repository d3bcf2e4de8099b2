import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { animatedWebp } from '../../../tools/pictures/animatedWebp.js';
import { root } from '../docs/documents.js';

/** The chunks of a RIFF file or of a part of one, with their names. */
function chunksOf(bytes: Buffer): { name: string; content: Buffer }[] {
  const chunks = [];
  for (let at = 0; at < bytes.length; ) {
    const length = bytes.readUInt32LE(at + 4);
    chunks.push({ name: bytes.toString('latin1', at, at + 4), content: bytes.subarray(at + 8, at + 8 + length) });
    at += 8 + length + (length % 2);
  }
  return chunks;
}

const chunk = (name: string, content: number[]): Buffer => {
  const header = Buffer.alloc(8);
  header.write(name, 'latin1');
  header.writeUInt32LE(content.length, 4);
  return Buffer.concat([header, Buffer.from(content), Buffer.alloc(content.length % 2)]);
};

const still = (...chunks: Buffer[]): Buffer => chunk('RIFF', [...Buffer.concat([Buffer.from('WEBP'), ...chunks])]);

test('still pictures become frames of one that moves', () => {
  const pictures = [
    still(chunk('VP8 ', [1, 2, 3])),
    still(chunk('VP8X', [0, 0]), chunk('ICCP', [7]), chunk('ALPH', [4]), chunk('VP8L', [5, 6])),
  ];
  const file = animatedWebp(pictures, { width: 700, height: 420, milliseconds: 90 });

  const [riff, ...rest] = chunksOf(file);
  expect([riff.name, rest]).toEqual(['RIFF', []]);
  expect(riff.content.toString('latin1', 0, 4)).toBe('WEBP');
  const [format, loop, ...frames] = chunksOf(riff.content.subarray(4));
  // The size less one, in 24 bits each.
  const size = [0xbb, 0x02, 0, 0xa3, 0x01, 0];
  expect([format.name, [...format.content]]).toEqual(['VP8X', [2, 0, 0, 0, ...size]]);
  expect([loop.name, [...loop.content]]).toEqual(['ANIM', [0, 0, 0, 0, 0, 0]]);
  const pixels = frames.map(({ name, content }) => {
    expect([name, [...content.subarray(0, 16)]]).toEqual(['ANMF', [0, 0, 0, 0, 0, 0, ...size, 90, 0, 0, 2]]);
    return chunksOf(content.subarray(16)).map((part) => [part.name, [...part.content]]);
  });
  expect(pixels).toEqual([
    [['VP8 ', [1, 2, 3]]],
    [
      ['ALPH', [4]],
      ['VP8L', [5, 6]],
    ],
  ]);
  expect(() => animatedWebp([Buffer.from('a PNG image')], { width: 1, height: 1, milliseconds: 1 })).toThrow(
    'not a WebP',
  );
});

test('the picture at the top of the README moves and weighs at most 1.5 MB', () => {
  const file = readFileSync(`${root}docs/hero.webp`);
  expect(file.length).toBeLessThanOrEqual(1.5e6);
  const names = chunksOf(chunksOf(file)[0].content.subarray(4)).map(({ name }) => name);
  expect(names.filter((name) => name === 'ANMF').length).toBeGreaterThan(20);
});
