import { expect, test, vi } from 'vitest';
import { HatchingMaterial } from '../../../src/index.js';

const table = ({ uniforms }: HatchingMaterial) => uniforms.toneCurveTable.value;

test('materials that print their tones alike share the texels of a table, and each frees its own texture', () => {
  const [a, b] = [new HatchingMaterial({ toneCurve: 'printed' }), new HatchingMaterial({ toneCurve: 'printed' })];
  const first = table(b);
  expect(first).not.toBe(table(a));
  expect(first.source).toBe(table(a).source);
  const { version } = first.source;
  b.toneCurve = 'printed';
  expect(table(b)).toBe(first);
  const freed = vi.fn();
  first.addEventListener('dispose', freed);
  b.toneCurve = [
    [0, 0],
    [1, 1],
  ];
  expect(freed).toHaveBeenCalledOnce();
  expect(table(b).source).not.toBe(table(a).source);
  expect(table(a).source.version).toBe(version);
  const freedOwn = vi.fn();
  table(b).addEventListener('dispose', freedOwn);
  b.dispose();
  expect(freedOwn).toHaveBeenCalledOnce();
});
