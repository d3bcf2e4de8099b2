import type { FromWorker, ToWorker } from '../../../src/worker/protocol.js';

/** A worker that does what the test tells it, and remembers what it was told. */
export class FakeWorker {
  onmessage: ((event: { data: FromWorker }) => void) | null = null;
  onmessageerror: (() => void) | null = null;
  onerror: ((event: { message?: string }) => void) | null = null;
  readonly received: ToWorker[] = [];
  readonly transferred: Transferable[][] = [];
  isTerminated = false;

  /** Answers questions for a sign of life. */
  isAlive = true;
  /** How often it was asked for one. */
  pings = 0;

  postMessage(message: ToWorker, transfer: Transferable[]): void {
    if (message.type === 'ping') {
      this.pings++;
      if (this.isAlive) this.say({ type: 'alive' });
      return;
    }
    this.received.push(structuredClone(message, { transfer }));
    this.transferred.push(transfer);
  }

  terminate(): void {
    this.isTerminated = true;
  }

  /** Lets the worker speak. */
  say(message: FromWorker): void {
    this.onmessage?.({ data: message });
  }

  /** Ids of the requests that the worker has got. */
  get ids(): number[] {
    return this.received.flatMap((message) => (message.type === 'run' ? [message.id] : []));
  }

  static asWorker(worker: FakeWorker): Worker {
    return worker as unknown as Worker;
  }
}
