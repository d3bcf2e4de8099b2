import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { mapIsReady, sharedMap } from '../../../src/material/mapInUse.js';
import { TonalArtMap } from '../../../src/material/tam/TonalArtMap.js';
import { eventually } from '../patience.js';

const drawn = TonalArtMap.fromHatchImages({ size: 1, images: [[new Uint8Array([255])], [new Uint8Array(1)]] });
const failing = (): TonalArtMap =>
  Object.assign(Object.create(TonalArtMap.prototype), { drawn: Promise.reject(new Error('no pen')) });

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
});
afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
});

test('a map that could not be drawn is reported, and tried again by a frame some seconds later', async () => {
  const told = vi.spyOn(console, 'error').mockImplementation(() => {});
  const shared = vi.spyOn(TonalArtMap, 'shared').mockImplementation(failing);
  expect(sharedMap('dashes')).toBe(null);
  await eventually(() => expect(told).toHaveBeenCalledOnce());
  expect(told.mock.calls[0][0]).toMatch(/the map of the style "dashes" could not be drawn \(no pen\)/);
  sharedMap('dashes');
  expect(shared).toHaveBeenCalledOnce();
  shared.mockReturnValue(drawn);
  vi.advanceTimersByTime(5000);
  sharedMap('dashes');
  await eventually(() => expect(sharedMap('dashes')).toBe(drawn));
  expect([shared.mock.calls.length, told.mock.calls.length]).toEqual([2, 1]);
});

test('waiting for a map that cannot be drawn rejects, and the next wait tries again', async () => {
  const shared = vi.spyOn(TonalArtMap, 'shared').mockImplementationOnce(failing).mockReturnValueOnce(drawn);
  await expect(mapIsReady('ruled')).rejects.toThrow('no pen');
  await mapIsReady('ruled');
  expect(shared).toHaveBeenCalledTimes(2);
  expect(sharedMap('ruled'), 'in the first frame after').toBe(drawn);
  await mapIsReady(null);
});
