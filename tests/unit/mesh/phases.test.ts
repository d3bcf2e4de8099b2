import { afterEach, expect, test, vi } from 'vitest';
import { release } from '../../../src/mesh/phases.js';

const { prototype } = ArrayBuffer as unknown as { prototype: { transfer?: (length: number) => ArrayBuffer } };
const own = Object.getOwnPropertyDescriptor(prototype, 'transfer');

afterEach(() => {
  if (own) Object.defineProperty(prototype, 'transfer', own);
  else delete prototype.transfer;
});

test('releases the memory of each array once', () => {
  const transfer = vi.fn(function (this: ArrayBuffer) {
    structuredClone(this, { transfer: [this] });
    return new ArrayBuffer(0);
  });
  prototype.transfer = transfer;
  const positions = new Float32Array(6);
  const [first, second] = [positions.subarray(0, 3), positions.subarray(3)];
  release(first, second, new Uint32Array(2));
  expect(transfer.mock.calls).toEqual([[0], [0]]);
  expect([first.length, second.length, positions.length]).toEqual([0, 0, 0]);
});

test('does nothing where the engine cannot transfer buffers', () => {
  delete prototype.transfer;
  const values = Float32Array.of(1, 2);
  release(values);
  expect([...values]).toEqual([1, 2]);
});
