import { expect, test, vi } from 'vitest';
import { warnOfMissingSource } from '../../../src/element/HatchedModelElement.js';

test('an element that never had a src says so, once on a page; one that was emptied says nothing', () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  warnOfMissingSource(true);
  expect(warn).not.toHaveBeenCalled();
  for (let i = 0; i < 2; i++) warnOfMissingSource(false);
  expect(warn.mock.calls).toEqual([
    ['<hatched-model>: there is no src, so nothing is shown. Set src to the address of a glTF or GLB file.'],
  ]);
  warn.mockRestore();
});
