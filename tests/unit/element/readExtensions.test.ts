import { expect, test } from 'vitest';
import { readExtensions } from '../../../src/element/readExtensions.js';
import { packGlb } from '../../../tools/modelFiles/columnModel.js';

const bytesOf = (content: Uint8Array): ArrayBuffer => Uint8Array.from(content).buffer;
const json = (extensions: object): string => JSON.stringify({ asset: { version: '2.0' }, name: '木', ...extensions });

test('the extensions of a file are read, in both forms of glTF', () => {
  const text = json({ extensionsUsed: ['A', 'B'], extensionsRequired: ['B'] });
  for (const content of [Buffer.from(text), packGlb(text, Buffer.alloc(8))]) {
    expect(readExtensions(bytesOf(content))).toEqual({ used: ['A', 'B'], required: ['B'] });
  }
});

test('there are none if none are listed, or if the file is no glTF', () => {
  const none = { used: [], required: [] };
  const glb = packGlb(json({ extensionsUsed: ['A'] }), Buffer.alloc(0));
  const damaged = Buffer.from(json({ extensionsUsed: 5, extensionsRequired: [null] }));
  for (const content of [
    Buffer.from(json({})),
    damaged,
    Buffer.alloc(0),
    Buffer.from('<!doctype html>'),
    glb.subarray(0, 30),
  ]) {
    expect(readExtensions(bytesOf(content))).toEqual(none);
  }
});
