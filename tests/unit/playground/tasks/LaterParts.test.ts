import { expect, test, vi } from 'vitest';
import { LaterParts } from '../../../../src/playground/tasks/LaterParts.js';
import { eventually } from '../../patience.js';
import { fakeStatus } from './fakeStatus.js';

test('a part is fetched when it is first asked for, and created once, however often it is asked for meanwhile', async () => {
  const parts = new LaterParts(fakeStatus().status);
  const create = vi.fn(async () => ({ name: 'gallery' }));
  const gallery = parts.later(create);
  expect([create.mock.calls.length, gallery.present, parts.isFetching]).toEqual([0, undefined, false]);
  const used: unknown[] = [];
  gallery.use((part) => used.push(part));
  gallery.use((part) => used.push(part));
  expect(parts.isFetching).toBe(true);
  await eventually(() => expect(parts.isFetching).toBe(false));
  expect(create).toHaveBeenCalledTimes(1);
  expect(used).toEqual([gallery.present, gallery.present]);
  expect(await gallery.fetch()).toBe(gallery.present);
});

test('a part that cannot be fetched is shown in the status line, and fetched again when it is next asked for', async () => {
  const line = fakeStatus();
  const parts = new LaterParts(line.status);
  let isOffline = true;
  const dialog = parts.later(async () => {
    if (isOffline) throw new TypeError('Failed to fetch dynamically imported module: http://x/a.js');
    return 'dialog';
  });
  dialog.use(() => {});
  await eventually(() => expect(parts.isFetching).toBe(false));
  expect([line.isError, dialog.present]).toEqual([true, undefined]);
  expect(line.text).toMatch(/^A part of this page could not be fetched\./);
  isOffline = false;
  const use = vi.fn();
  dialog.use(use);
  await eventually(() => expect(use).toHaveBeenCalledWith('dialog'));
});

test('a part that cannot be used is shown in the status line', async () => {
  const line = fakeStatus();
  const parts = new LaterParts(line.status);
  parts.whenFetched(Promise.resolve('part'), () => Promise.reject(new Error('no room')));
  await eventually(() => expect(parts.isFetching).toBe(false));
  expect(line.text).toBe('That did not work: no room');
});
