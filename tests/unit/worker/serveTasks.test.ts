import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { FromWorker, ToWorker } from '../../../src/worker/protocol.js';
import { serveTasks } from '../../../src/worker/serveTasks.js';
import { eventually } from '../patience.js';

/** What the worker has said. */
let said: FromWorker[];
let hear: (message: ToWorker) => void;
/** Lets the tasks that wait go on. */
let goOn: boolean;

function* task({ fails }: { fails: boolean }): Generator<number, string, void> {
  for (let share = 0; !goOn; share += 1e-6) yield share;
  if (fails) throw new RangeError('too far');
  return 'done';
}

beforeEach(() => {
  said = [];
  goOn = false;
  vi.stubGlobal('postMessage', (message: FromWorker) => said.push(message));
  vi.stubGlobal('onmessage', null);
  vi.stubGlobal('navigator', {});
  serveTasks({ task: { run: task } } as never);
  hear = (data) => (globalThis as unknown as { onmessage: (event: object) => void }).onmessage({ data });
});

afterEach(() => void vi.unstubAllGlobals());

const run = (id: number, fails = false) => hear({ type: 'run', id, task: 'task', request: { fails } } as never);
const ends = () => said.filter(({ type }) => type === 'done' || type === 'failed');

test('a task ends with its result, or with its error', async () => {
  run(0);
  run(1, true);
  goOn = true;
  await eventually(() => expect(ends()).toHaveLength(2));
  expect(ends()).toMatchObject([
    { type: 'done', id: 0, result: 'done' },
    { type: 'failed', id: 1, error: { name: 'RangeError', message: 'too far' } },
  ]);
});

test('of a task that was aborted nothing is said, and the others go on', async () => {
  run(0);
  run(1);
  hear({ type: 'abort', id: 0 });
  // A sign of life tells that the messages before it were heard.
  hear({ type: 'ping' });
  expect(said.some(({ type }) => type === 'alive')).toBe(true);
  await eventually(() => expect(said.some(({ type }) => type === 'progress')).toBe(true));
  goOn = true;
  run(2);
  const ended = () => ends().map((message) => (message as { id: number }).id);
  await eventually(() => expect(ended()).toEqual(expect.arrayContaining([1, 2])));
  // In whatever order they end.
  expect(ended().sort()).toEqual([1, 2]);
  expect(ends().every(({ type }) => type === 'done')).toBe(true);
});

test('what no worker of its kind can do is refused with the names of those that can', async () => {
  hear({ type: 'run', id: 7, task: 'other', request: {} } as never);
  await eventually(() => expect(ends()).toHaveLength(1));
  expect(ends()[0]).toMatchObject({ id: 7, error: { message: expect.stringContaining('three-hatching/svg.worker') } });
});
