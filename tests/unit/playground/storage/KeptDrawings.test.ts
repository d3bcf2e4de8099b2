import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { type KeptDrawing, KeptDrawings } from '../../../../src/playground/session/KeptDrawings.js';

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

describe('the drawings that are kept', () => {
  test('are listed with the latest first, and given back with their files', async () => {
    const { drawings } = database();
    await drawings.keep(drawing('a', 1), { map: [] });
    await drawings.keep(drawing('b', 3), {});
    await drawings.keep(drawing('c', 2), {});
    expect((await drawings.list()).map(({ id }) => id)).toEqual(['b', 'c', 'a']);
    expect(await drawings.read('a')).toEqual({ drawing: drawing('a', 1), files: { map: [] } });
  });

  test('are twelve at most: the oldest is deleted, with its files', async () => {
    const { drawings, stores } = database();
    for (let i = 0; i < 13; i++) await drawings.keep(drawing(`${i}`, i), {});
    expect((await drawings.list()).map(({ id }) => id)).toEqual(Array.from({ length: 12 }, (_, i) => `${12 - i}`));
    expect([...stores.files!.keys()]).not.toContain('0');
  });

  test('lose one of the same title and size', async () => {
    const { drawings } = database();
    await drawings.keep(drawing('a', 1, { title: 'Bust', bytes: 7 }), {});
    await drawings.keep(drawing('b', 2, { title: 'Bust', bytes: 8 }), {});
    await drawings.keep(drawing('c', 3, { title: 'Bust', bytes: 7 }), {});
    expect((await drawings.list()).map(({ id }) => id)).toEqual(['c', 'b']);
  });

  test('make room, the oldest first, where the browser has no more', async () => {
    const { drawings, limit } = database();
    for (const [i, id] of ['a', 'b', 'c'].entries()) await drawings.keep(drawing(id, i), {});
    limit(2);
    await drawings.keep(drawing('d', 9), {});
    expect((await drawings.list()).map(({ id }) => id)).toEqual(['d', 'c']);
    limit(0);
    await expect(drawings.keep(drawing('e', 10), {})).rejects.toThrow('full');
  });

  test('are changed, unless they were deleted', async () => {
    const { drawings } = database();
    await drawings.keep(drawing('a', 1), {});
    await drawings.update({ id: 'a', title: 'Renamed' });
    expect(await drawings.list()).toEqual([drawing('a', 1, { title: 'Renamed' })]);
    await drawings.forget('a');
    await drawings.update({ id: 'a', title: 'Again' });
    expect(await drawings.list()).toEqual([]);
  });
});

const drawing = (id: string, at: number, changes: Partial<KeptDrawing> = {}): KeptDrawing => ({
  ...{ id, title: id, at, bytes: 0, link: '', camera: undefined },
  ...changes,
});

/** Drawings in a database that answers at once, and holds as many as the test allows. */
function database() {
  const stores: Record<string, Map<string, unknown>> = { drawings: new Map(), files: new Map() };
  let most = Infinity;
  const store = (name: string, stop: () => void) => {
    const entries = stores[name]!;
    const put = (value: { id: string }, key = value.id) => {
      if (!entries.has(key) && entries.size >= most) stop();
      else entries.set(key, value);
      return { result: key };
    };
    return {
      put,
      get: (key: string) => ({ result: entries.get(key) }),
      getAll: () => ({ result: [...entries.values()] }),
      delete: (key: string) => void entries.delete(key),
    };
  };
  const transaction = () => {
    const made = Object.assign(new Silent(), {
      error: undefined as unknown,
      objectStore: (name: string) =>
        store(name, () => {
          made.error = new DOMException('full', 'QuotaExceededError');
        }),
    });
    queueMicrotask(() => made.tell(made.error ? 'abort' : 'complete'));
    return made;
  };
  const opening = new Silent();
  vi.stubGlobal('indexedDB', { open: () => opening });
  const drawings = new KeptDrawings();
  queueMicrotask(() => opening.tell('success', Object.assign(new Silent(), { transaction })));
  return {
    drawings,
    stores,
    limit: (count: number) => {
      most = count;
    },
  };
}
