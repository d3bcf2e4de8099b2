/** The real worker, but it closes itself while it works on its first request. No event tells the page. */
import '../../src/worker/bake.worker.js';

const scope = globalThis as unknown as {
  onmessage: (event: MessageEvent) => void;
  postMessage(message: unknown): void;
  close(): void;
};
const handle = scope.onmessage;
scope.onmessage = (event) => {
  handle(event);
  scope.postMessage({ type: 'alive' });
  scope.close();
};
