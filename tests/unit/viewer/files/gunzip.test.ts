import { randomBytes } from 'node:crypto';
import { gzipSync } from 'node:zlib';
import { expect, test } from 'vitest';
import { gunzip } from '../../../../src/viewer/files/readArchive.js';

const MEGABYTE = 2 ** 20;
const ALL = 512 * MEGABYTE;

test('gzipped bytes are unpacked, and others are returned as they are', async () => {
  const content = randomBytes(100_000);
  expect(Buffer.from(await gunzip(gzipSync(content), 'a.gz', ALL)).equals(content)).toBe(true);
  expect(await gunzip(content, 'a', ALL)).toBe(content);
});

test('a small archive may unpack to 64 megabytes, and not to more', async () => {
  const bytes = gzipSync(new Uint8Array(64 * MEGABYTE), { level: 1 });
  expect((await gunzip(bytes, 'a.gz', ALL)).length).toBe(64 * MEGABYTE);
  const bomb = gzipSync(new Uint8Array(65 * MEGABYTE), { level: 1 });
  // Not the bytes themselves: a failing test would print them.
  const unpacked = gunzip(bomb, 'a.gz', ALL).then(({ length }) => length);
  await expect(unpacked).rejects.toThrow(/^a\.gz unpacks to more than 64 MB, .*\.$/);
});

test('no archive may unpack to more than files may have', async () => {
  await expect(gunzip(gzipSync(new Uint8Array(3 * MEGABYTE)), 'a.gz', 2 * MEGABYTE)).rejects.toThrow('more than 2 MB');
});

test('damaged archives', async () => {
  const bytes = gzipSync(randomBytes(1000));
  const sentence = 'a.gz could not be unpacked: it is damaged or was cut short.';
  await expect(gunzip(bytes.subarray(0, 500), 'a.gz', ALL)).rejects.toThrow(sentence);
  await expect(gunzip(bytes.fill(0xff, 100, 200), 'a.gz', ALL)).rejects.toThrow(sentence);
});
