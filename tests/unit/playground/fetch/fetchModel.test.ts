import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { FetchMessage } from '../../../../src/playground/fetch/fetchMain.js';
import { describeAddress, fetchModel } from '../../../../src/playground/fetch/fetchModel.js';

const ORIGIN = 'https://page.test';
const ADDRESS = 'https://models.test/a%20bunny.ply';

let page: EventTarget;
/** The frames that are on the page. */
let frames: { src: string; contentWindow: { postMessage: ReturnType<typeof vi.fn> } }[];

beforeEach(() => {
  page = new EventTarget();
  frames = [];
  vi.stubGlobal('addEventListener', page.addEventListener.bind(page));
  vi.stubGlobal('removeEventListener', page.removeEventListener.bind(page));
  vi.stubGlobal('location', { origin: ORIGIN });
  vi.stubGlobal('document', {
    baseURI: `${ORIGIN}/playground/`,
    createElement: () => {
      const frame = {
        ...{ src: '', hidden: false, contentWindow: { postMessage: vi.fn() } },
        remove: () => void frames.splice(frames.indexOf(frame), 1),
      };
      return frame;
    },
    body: { append: (frame: (typeof frames)[number]) => frames.push(frame) },
  });
});

afterEach(() => void vi.unstubAllGlobals());

/** Asks for a model, and lets its frame, or anybody else, say something. */
function ask(signal = new AbortController().signal) {
  const onProgress = vi.fn();
  const model = fetchModel(ADDRESS, { signal, onProgress });
  model.catch(() => {});
  const [frame] = frames;
  const say = (data: FetchMessage, source: unknown = frame.contentWindow, origin = ORIGIN): void => {
    page.dispatchEvent(Object.assign(new Event('message'), { source, origin, data }));
  };
  return { model, frame, say, onProgress };
}

test('only the page in the frame is told the address, and its response is a file of that name', async () => {
  const { model, frame, say, onProgress } = ask();
  expect(frame.src).toBe(`${ORIGIN}/playground/fetch/`);
  say({ kind: 'ready' });
  expect(frame.contentWindow.postMessage).toHaveBeenCalledExactlyOnceWith({ address: ADDRESS }, ORIGIN);
  say({ kind: 'progress', bytes: 20, total: 80 });
  say({ kind: 'progress', bytes: 40, total: undefined });
  expect(onProgress.mock.calls).toEqual([[0.25], [undefined]]);
  const content = new Blob(['ply']);
  say({ kind: 'done', content });
  expect(await model).toEqual({ name: 'a bunny.ply', content });
  expect(frames).toEqual([]);
});

test('messages of other windows and sites are ignored', () => {
  const { frame, say } = ask();
  say({ kind: 'ready' }, {});
  say({ kind: 'ready' }, frame.contentWindow, 'https://evil.test');
  say({ kind: 'done', content: new Blob(['evil']) }, {});
  expect([frame.contentWindow.postMessage.mock.calls, frames.length]).toEqual([[], 1]);
});

test.each([
  [{ kind: 'refused', status: 404 }, /^models\.test has no such file: it answered 404 for a bunny\.ply\.$/],
  [{ kind: 'too large' }, /^a bunny\.ply has more than 512 MB/],
  [{ kind: 'redirected' }, /^a bunny\.ply did not come: models\.test redirects to another site/],
  [{ kind: 'failed' }, /^a bunny\.ply did not come: models\.test cannot be reached/],
] as const)('what goes wrong is said in a sentence, and the frame goes: %o', async (message, sentence) => {
  const { model, say } = ask();
  say(message);
  await expect(model).rejects.toThrow(sentence);
  expect(frames).toEqual([]);
});

test('an abort removes the frame, and with it the request', async () => {
  const controller = new AbortController();
  const { model } = ask(controller.signal);
  controller.abort(new Error('enough'));
  await expect(model).rejects.toThrow('enough');
  expect(frames).toEqual([]);
});

test('an address is described by its file and by its host in ASCII', () => {
  expect(describeAddress('https://аррӏе.com/a/b%20c.glb?x#y')).toEqual({ name: 'b c.glb', site: 'xn--80ak6aa92e.com' });
  expect(describeAddress('https://trusted.test:x@evil.test:8443/%E0%A4%A')).toEqual({
    name: '%E0%A4%A',
    site: 'evil.test:8443',
  });
  expect(describeAddress('https://a.test/')).toEqual({ name: 'model', site: 'a.test' });
});
