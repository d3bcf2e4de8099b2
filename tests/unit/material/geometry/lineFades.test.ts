import { BufferGeometry } from 'three';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { fadeIn, fadeOut, lineContrast, showLines } from '../../../../src/material/geometry/lineFades.js';

const motion = (isReduced: boolean): void => void vi.stubGlobal('matchMedia', () => ({ matches: isReduced }));
const never = new AbortController().signal;

beforeEach(() => {
  vi.useFakeTimers();
});

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test('lines fade into grey, stay there, and fade in again, with a frame for each step', async () => {
  motion(false);
  const [before, after, other] = [new BufferGeometry(), new BufferGeometry(), new BufferGeometry()];
  const seen: number[] = [];
  const out = fadeOut([before], never, () => seen.push(lineContrast(before)));
  await vi.advanceTimersByTimeAsync(400);
  await out;
  expect(lineContrast(before)).toBe(0);
  expect(seen.length).toBeGreaterThan(10);
  expect(seen).toEqual([...seen].sort((a, b) => b - a));
  expect(seen[0]).toBe(1);
  const back = fadeIn([after], never, () => {});
  expect(lineContrast(after)).toBe(0);
  await vi.advanceTimersByTimeAsync(150);
  expect(lineContrast(after)).toBeCloseTo(0.5, 1);
  await vi.advanceTimersByTimeAsync(250);
  await back;
  expect([lineContrast(after), lineContrast(other)]).toEqual([1, 1]);
  showLines([before]);
  expect(lineContrast(before)).toBe(1);
});

test('nothing fades if reduced motion is preferred, and no frame is requested', async () => {
  motion(true);
  const geometry = new BufferGeometry();
  const onFrame = vi.fn();
  await fadeOut([geometry], never, onFrame);
  expect(lineContrast(geometry)).toBe(1);
  await fadeIn([geometry], never, onFrame);
  expect(onFrame).not.toHaveBeenCalled();
});

test('an abort ends a fade', async () => {
  motion(false);
  const stopping = new AbortController();
  const geometry = new BufferGeometry();
  const fade = fadeIn([geometry], stopping.signal, () => stopping.abort());
  await vi.advanceTimersByTimeAsync(20);
  await fade;
  expect(lineContrast(geometry)).toBe(1);
});
