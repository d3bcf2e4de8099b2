import BakeWorker from './bake.worker.js?worker&inline';
import { TaskClient } from './TaskClient.js';
import type { TaskOptions } from './TaskOptions.js';
import type { TaskName, TaskRequest, TaskResult } from './tasks.js';

const createInlineWorker = (): Worker | null => (typeof Worker === 'undefined' ? null : new BakeWorker());

/** One client per `createWorker` function, for as long as it has a worker. */
const clients = new Map<() => Worker | null, TaskClient>();

function clientFor(createWorker: () => Worker | null): TaskClient {
  let client = clients.get(createWorker);
  if (!client) {
    client = new TaskClient(createWorker, () => clients.delete(createWorker));
    clients.set(createWorker, client);
  }
  return client;
}

/**
 * Runs a task in the shared worker of the page, or in that of `options.createWorker`; without workers, in slices on the main
 * thread. The buffers of `request` are transferred: pass copies of what you want to keep.
 */
export function runTask<Name extends TaskName>(
  name: Name,
  request: TaskRequest<Name>,
  options: TaskOptions = {},
): Promise<TaskResult<Name>> {
  return clientFor(options.createWorker ?? createInlineWorker).run(name, request, options);
}

/**
 * Ends every worker that three-hatching has started and rejects all pending requests. Rarely needed: idle workers end by
 * themselves. The next request starts a new one.
 */
export function disposeHatchingWorkers(): void {
  for (const client of clients.values()) client.dispose();
  clients.clear();
}
