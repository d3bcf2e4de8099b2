import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { KeptDrawings } from '../../../../src/demo/kept/KeptDrawings.js';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** What the browser hands out: it tells of nothing until the test lets it. */
class Silent extends EventTarget {
  result: unknown;
  tell(name: string, result?: unknown): void {
    this.result = result;
    this.dispatchEvent(new Event(name));
  }
}

/** A database whose transactions and requests are as silent. */
function silentDatabase() {
  const transactions: (Silent & { request: Silent })[] = [];
  const database = Object.assign(new Silent(), {
    transaction: () => {
      const request = new Silent();
      const store = { get: () => request, getAll: () => request, put: () => request, delete: () => request };
      const transaction = Object.assign(new Silent(), { objectStore: () => store, request });
      transactions.push(transaction);
      return transaction;
    },
  });
  return { database, transactions };
}

/** How a promise has ended by now. */
function watch(promise: Promise<unknown>): { state: string } {
  const seen = { state: 'waits' };
  promise.then(
    (value) => {
      seen.state = `gives ${JSON.stringify(value)}`;
    },
    ({ message }: Error) => {
      seen.state = message;
    },
  );
  return seen;
}

describe('a browser that does not answer', () => {
  test('when the database is opened is waited for two seconds, each time until it does', async () => {
    const opening = new Silent();
    vi.stubGlobal('indexedDB', { open: () => opening });
    const drawings = new KeptDrawings();
    const read = watch(drawings.read('a'));
    await vi.advanceTimersByTimeAsync(1900);
    expect(read.state).toBe('waits');
    await vi.advanceTimersByTimeAsync(200);
    expect(read.state).toBe('The browser does not answer.');

    const { database, transactions } = silentDatabase();
    const list = watch(drawings.list());
    opening.tell('success', database);
    await vi.advanceTimersByTimeAsync(0);
    transactions[0].request.result = [];
    transactions[0].tell('complete');
    await vi.advanceTimersByTimeAsync(0);
    expect(list.state).toBe('gives []');
  });

  test('when something is read is waited for two seconds; what is written may take longer', async () => {
    const opening = new Silent();
    vi.stubGlobal('indexedDB', { open: () => opening });
    const { database, transactions } = silentDatabase();
    const drawings = new KeptDrawings();
    const read = watch(drawings.read('a'));
    opening.tell('success', database);
    const forgotten = watch(drawings.forget('a'));
    await vi.advanceTimersByTimeAsync(60_000);
    expect(read.state).toBe('The browser does not answer.');
    expect(forgotten.state).toBe('waits');
    transactions[1].tell('complete');
    await vi.advanceTimersByTimeAsync(0);
    expect(forgotten.state).toBe('gives undefined');
  });

  test('for a while because the page is busy has not missed its time', async () => {
    const opening = new Silent();
    vi.stubGlobal('indexedDB', { open: () => opening });
    const { database } = silentDatabase();
    const read = watch(new KeptDrawings().read('a'));
    // All that waits for a page that was busy for ten seconds comes at once, the timer first.
    vi.setSystemTime(Date.now() + 10_000);
    await vi.advanceTimersToNextTimerAsync();
    opening.tell('success', database);
    await vi.advanceTimersByTimeAsync(500);
    expect(read.state).toBe('waits');
  });
});
