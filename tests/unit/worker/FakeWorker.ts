import type { FromWorker, ToWorker } from '../../../src/worker/protocol.js';

/** A worker controlled by the test, which records its messages. */
export class FakeWorker {
  onmessage: ((event: { data: FromWorker }) => void) | null = null;
  onmessageerror: (() => void) | null = null;
  onerror: ((event: { message?: string }) => void) | null = null;
  readonly received: ToWorker[] = [];
  readonly transferred: Transferable[][] = [];
  isTerminated = false;

  /** Whether it answers pings. */
  isAlive = true;
  /** The number of pings received. */
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

  /** Sends a message from the worker. */
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
