import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { SILENCE_SECONDS, SilenceWatch } from '../../../src/worker/SilenceWatch.js';

const ping = vi.fn();
const onSilence = vi.fn();
let watch: SilenceWatch;

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] });
  vi.clearAllMocks();
  watch = new SilenceWatch(ping, onSilence);
  watch.start();
});

afterEach(() => {
  watch.stop();
  vi.restoreAllMocks();
  vi.useRealTimers();
});

const seconds = (count: number) => vi.advanceTimersByTime(1000 * count);

test('pings every second, and reports once after half a minute of silence', () => {
  seconds(SILENCE_SECONDS - 1);
  expect([ping.mock.calls.length, onSilence.mock.calls.length]).toEqual([SILENCE_SECONDS - 1, 0]);
  seconds(100);
  expect([ping.mock.calls.length, onSilence.mock.calls.length]).toEqual([SILENCE_SECONDS - 1, 1]);
});

test('a message restarts the count', () => {
  seconds(SILENCE_SECONDS - 1);
  watch.hear();
  seconds(SILENCE_SECONDS - 1);
  expect(onSilence).not.toHaveBeenCalled();
  seconds(1);
  expect(onSilence).toHaveBeenCalledOnce();
});

test.each([
  ['a timer that is a little late counts', 900, 1],
  ['one that is a second late begins the count anew', 1000, 0],
])('%s', (_, late, silences) => {
  const clock = performance.now.bind(performance);
  let slept = 0;
  vi.spyOn(performance, 'now').mockImplementation(() => clock() + slept);
  seconds(SILENCE_SECONDS - 1);
  slept += late;
  seconds(1);
  expect(onSilence).toHaveBeenCalledTimes(silences);
});

test('a watch that is started twice pings once per second', () => {
  watch.start();
  seconds(1);
  expect(ping).toHaveBeenCalledOnce();
});
