import { expect, it } from 'vitest';
import { buffersIn } from '../../../src/worker/TaskSet.js';

it('an image shared by two tones is transferred once, and stays shared', () => {
  const [paper, ink] = [255, 0].map((byte) => new Uint8Array(4).fill(byte));
  const images = [[paper], [ink], [ink]];
  const received = structuredClone(images, { transfer: buffersIn({ size: 2, images }) });
  expect(received).toEqual([[255], [0], [0]].map((row) => row.map((byte) => new Uint8Array(4).fill(byte))));
});

it('arrays are found wherever they lie, views of shared memory aside', () => {
  const [a, b] = [new Float32Array(3), new Uint8Array(2)];
  const shared = new Uint8Array(new SharedArrayBuffer(4));
  expect(buffersIn({ a, rows: [{ b }, [new Uint8Array(b.buffer, 1)], null, 'text', 1], shared })).toEqual([
    a.buffer,
    b.buffer,
  ]);
  expect(buffersIn('text')).toEqual([]);
});
