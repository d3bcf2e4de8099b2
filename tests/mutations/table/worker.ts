import type { Mutation } from '../Mutation.js';

export const worker: readonly Mutation[] = [
  {
    name: 'progress may fall',
    file: 'src/worker/TaskClient.ts',
    find: '|| progress <= entry.progress',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/worker/TaskClient.test.ts',
      title: 'reports rising progress to the right request, then 1',
    },
  },
  {
    name: 'an aborted request goes on in the worker',
    file: 'src/worker/TaskClient.ts',
    find: "        this.send({ type: 'abort', id });\n        this.settle(id)?.reject(signal!.reason);",
    replace: '        this.settle(id)?.reject(signal!.reason);',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/worker/TaskClient.test.ts',
      title: 'while it runs: rejects at once, notifies the worker, and does not affect others',
    },
  },
  {
    name: 'a task dies with one worker alone',
    file: 'src/worker/TaskClient.ts',
    find: 'MAX_DEATHS = 2',
    replace: 'MAX_DEATHS = 1',
    caughtBy: { layer: 'unit', file: 'tests/unit/worker/deaths.test.ts', title: 'a geometry of layout … workers' },
  },
  {
    name: 'the busiest worker gets the next request',
    file: 'src/worker/WorkerPool.ts',
    find: 'client.pendingCount < least.pendingCount',
    replace: 'client.pendingCount > least.pendingCount',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/worker/WorkerPool.test.ts',
      title: 'gives a request to the worker with the fewest requests',
    },
  },
  {
    name: 'an error of a task loses its class',
    file: 'src/worker/protocol.ts',
    find: 'new (errorClasses[name] ?? Error)(message)',
    replace: 'new Error(message)',
    caughtBy: { layer: 'unit', file: 'tests/unit/worker/TaskClient.test.ts', title: 'rebuilds the error of a task' },
  },
  {
    name: 'late timers count as silence',
    file: 'src/worker/SilenceWatch.ts',
    find: 'isVisible && lateness < TICK_MS',
    replace: 'isVisible',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/worker/SilenceWatch.test.ts',
      title: 'one that is a second late begins the count anew',
    },
  },
  {
    name: 'a timer that is hardly late begins the count anew',
    file: 'src/worker/SilenceWatch.ts',
    find: 'isVisible && lateness < TICK_MS',
    replace: 'isVisible && lateness < 0.5 * TICK_MS',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/worker/SilenceWatch.test.ts',
      title: 'a timer that is a little late counts',
    },
  },
  {
    name: 'an aborted task fails as well',
    file: 'src/worker/serveTasks.ts',
    find: 'if (!controller.signal.aborted) scope',
    replace: 'scope',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/worker/serveTasks.test.ts',
      title: 'of a task that was aborted nothing is said, and the others go on',
    },
  },
  {
    name: 'an abort stops no task',
    file: 'src/worker/serveTasks.ts',
    find: "if (data.type === 'abort') running.get(data.id)?.abort();",
    replace: "if (data.type === 'abort') running.delete(data.id);",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/worker/serveTasks.test.ts',
      title: 'of a task that was aborted nothing is said, and the others go on',
    },
  },
];
