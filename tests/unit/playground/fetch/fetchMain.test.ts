import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { FetchMessage } from '../../../../src/playground/fetch/fetchMain.js';
import { eventually } from '../../patience.js';

const ORIGIN = 'https://page.test';
const ADDRESS = 'https://models.test/bunny.ply';

let frame: EventTarget;
let said: FetchMessage[];
/** The policies that the page has put itself under. */
let policies: string[];
let fetched: ReturnType<typeof vi.fn>;
let parent: object;

beforeEach(async () => {
  frame = new EventTarget();
  said = [];
  policies = [];
  fetched = vi.fn();
  parent = {
    postMessage: (message: FetchMessage, to: string) => {
      expect(to).toBe(ORIGIN);
      said.push(message);
    },
  };
  vi.stubGlobal('addEventListener', frame.addEventListener.bind(frame));
  vi.stubGlobal('location', { origin: ORIGIN });
  vi.stubGlobal('parent', parent);
  vi.stubGlobal('fetch', fetched);
  vi.stubGlobal('document', {
    createElement: () => ({}),
    head: { append: ({ content }: { content: string }) => policies.push(content) },
  });
  vi.resetModules();
  await import('../../../../src/playground/fetch/fetchMain.js');
});

afterEach(() => void vi.unstubAllGlobals());

const ask = (source: object = parent, origin = ORIGIN) =>
  frame.dispatchEvent(Object.assign(new Event('message'), { source, origin, data: { address: ADDRESS } }));

const kinds = () => said.map(({ kind }) => kind);

test('a file is fetched without cookies and referrer, and posted in parts', async () => {
  fetched.mockResolvedValue(new Response('ply', { headers: { 'Content-Length': '3' } }));
  expect(kinds()).toEqual(['ready']);
  ask();
  await eventually(() => expect(kinds()).toEqual(['ready', 'progress', 'done']));
  expect(fetched).toHaveBeenCalledExactlyOnceWith(ADDRESS, { credentials: 'omit', referrerPolicy: 'no-referrer' });
  expect(said[1]).toEqual({ kind: 'progress', bytes: 3, total: 3 });
  expect(await (said[2] as { content: Blob }).content.text()).toBe('ply');
});

test('before a request, the page blocks every other site', async () => {
  let before: string[] = [];
  fetched.mockImplementation(async () => {
    before = [...policies];
    return new Response('ply');
  });
  ask();
  await eventually(() => expect(kinds()).toContain('done'));
  expect(before).toEqual(['connect-src https://models.test']);
});

test('only the page around it may ask', () => {
  ask({}, ORIGIN);
  ask(parent, 'https://evil.test');
  expect([fetched.mock.calls, policies]).toEqual([[], []]);
});

test('reports HTTP errors, failed requests, and redirects to other sites', async () => {
  fetched.mockResolvedValueOnce(new Response('no', { status: 404 }));
  ask();
  await eventually(() => expect(said.at(-1)).toEqual({ kind: 'refused', status: 404 }));
  fetched.mockRejectedValueOnce(new TypeError('Failed to fetch'));
  ask();
  await eventually(() => expect(said.at(-1)).toEqual({ kind: 'failed' }));
  fetched.mockImplementationOnce(async () => {
    // As browsers do: after the request has failed.
    setTimeout(() => frame.dispatchEvent(new Event('securitypolicyviolation')));
    throw new TypeError('Failed to fetch');
  });
  ask();
  await eventually(() => expect(said.at(-1)).toEqual({ kind: 'redirected' }));
});
