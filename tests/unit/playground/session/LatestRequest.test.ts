import { expect, test } from 'vitest';
import { LatestRequest } from '../../../../src/playground/session/LinkFollower.js';

/** Something that is waited for until the test ends it. */
function open() {
  let resolve = (_result: string): void => {};
  let reject = (_error: Error): void => {};
  const ended = new Promise<string>((...ends) => {
    [resolve, reject] = ends;
  });
  const signals: AbortSignal[] = [];
  const task = (signal: AbortSignal): Promise<string> => {
    signals.push(signal);
    return ended;
  };
  return { resolve, reject, task, isAborted: () => signals[0].aborted };
}

test('only the later of two requests has a result, in whatever order they end', async () => {
  const request = new LatestRequest();
  const [first, second] = [open(), open()];
  const results = [request.run(first.task), request.run(second.task)];
  expect([first.isAborted(), second.isAborted()]).toEqual([true, false]);
  second.resolve('second');
  first.resolve('first');
  expect(await Promise.all(results)).toEqual([undefined, 'second']);
});

test('a failed request throws, unless it was replaced', async () => {
  const request = new LatestRequest();
  const [first, second] = [open(), open()];
  const dropped = request.run(first.task);
  request.drop();
  const failed = request.run(second.task);
  first.reject(new Error('first'));
  second.reject(new Error('second'));
  expect(await dropped).toBeUndefined();
  await expect(failed).rejects.toThrow('second');
});
