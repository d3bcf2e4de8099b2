import { expect, test, vi } from 'vitest';
import { SharedResources } from '../../../src/element/decoders.js';
import { eventually } from '../patience.js';

const resource = () => ({ dispose: vi.fn() });

test('a resource is made once for all its users, and freed when the last one gives it back', async () => {
  const shared = new SharedResources<string, { dispose(): void }>();
  const made = resource();
  const make = vi.fn(async () => made);
  expect(await shared.borrow('a', make)).toBe(made);
  expect(await shared.borrow('a', make)).toBe(made);
  expect(make).toHaveBeenCalledTimes(1);
  shared.giveBack('a');
  await Promise.resolve();
  expect(made.dispose).not.toHaveBeenCalled();
  shared.giveBack('a');
  await eventually(() => expect(made.dispose).toHaveBeenCalledTimes(1));
  await shared.borrow('a', make);
  expect(make).toHaveBeenCalledTimes(2);
});

test('one that could not be made is tried again once those who waited for it have given it back', async () => {
  const shared = new SharedResources<string, { dispose(): void }>();
  const fail = async (): Promise<never> => {
    throw new Error('no');
  };
  await expect(shared.borrow('a', fail)).rejects.toThrow('no');
  shared.giveBack('a');
  const made = resource();
  expect(await shared.borrow('a', async () => made)).toBe(made);
});
