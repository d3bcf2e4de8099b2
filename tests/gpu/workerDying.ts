/** The real worker, but it dies of an uncaught error while it works on its first request. */
import '../../src/worker/bake.worker.js';

const scope = globalThis as unknown as { onmessage: (event: MessageEvent) => void };
const handle = scope.onmessage;
scope.onmessage = (event) => {
  handle(event);
  setTimeout(() => {
    throw new Error('killed by the test');
  });
};
