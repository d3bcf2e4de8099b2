import { createElement } from 'react';
import { Group } from 'three';
import { expect, test, vi } from 'vitest';
import { warnIfEmpty } from '../../../src/react/Hatched.js';

test('<Hatched> without children and with an undefined object says so, once; null and children say nothing', () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  warnIfEmpty(null, undefined);
  warnIfEmpty(new Group(), undefined);
  warnIfEmpty(undefined, createElement('mesh'));
  expect(warn).not.toHaveBeenCalled();
  for (let i = 0; i < 2; i++) warnIfEmpty(undefined, undefined);
  expect(warn.mock.calls).toEqual([
    [expect.stringContaining('<Hatched> has no children, and its object is undefined, so there is nothing to hatch.')],
  ]);
  warn.mockRestore();
});
