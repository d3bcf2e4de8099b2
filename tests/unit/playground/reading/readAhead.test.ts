import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { type ReadAhead, takeReadAhead } from '../../../../src/playground/reading/loadModelFiles.js';

beforeEach(() => {
  vi.stubGlobal('document', { baseURI: 'https://example.org/page/index.html' });
});
afterEach(() => vi.unstubAllGlobals());

function begin(changes: Partial<ReadAhead> = {}): { ahead: ReadAhead; terminate: ReturnType<typeof vi.fn> } {
  const terminate = vi.fn();
  const worker = { terminate } as unknown as Worker;
  const url = 'https://example.org/page/assets/dragon.gz';
  const ahead = { url, files: Promise.resolve([]), worker, messages: [], hasFailed: false, ...changes };
  globalThis.hatchingReadAhead = ahead;
  return { ahead, terminate };
}

test('a reading begun ahead is taken once, for its own file', () => {
  const { ahead, terminate } = begin();
  expect(takeReadAhead('./assets/dragon.gz')).toBe(ahead);
  expect(takeReadAhead('./assets/dragon.gz')).toBeUndefined();
  expect(terminate).not.toHaveBeenCalled();
});

test('a reading begun ahead ends for another file, or if its worker has stopped', () => {
  const other = begin();
  expect(takeReadAhead('./assets/bunny.gz')).toBeUndefined();
  const failed = begin({ hasFailed: true });
  expect(takeReadAhead('./assets/dragon.gz')).toBeUndefined();
  expect([other, failed].map(({ terminate }) => terminate.mock.calls.length)).toEqual([1, 1]);
  expect(globalThis.hatchingReadAhead).toBeUndefined();
});
