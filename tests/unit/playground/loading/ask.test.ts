import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { askForStrokes, askToFetch } from '../../../../src/playground/loading/ask.js';

/** An element of a page that has nothing but questions. */
class FakeElement extends EventTarget {
  returnValue = '';
  disabled = false;
  textContent = '';
  value = '';
  isShown = false;
  readonly children: FakeElement[] = [];

  append(...children: FakeElement[]): void {
    this.children.push(...children);
  }

  setAttribute(): void {}

  showModal(): void {
    this.isShown = true;
  }

  remove(): void {
    this.isShown = false;
  }

  /** @param value that of the pressed button; Escape has none */
  close(value?: string): void {
    if (value !== undefined) this.returnValue = value;
    this.isShown = false;
    this.dispatchEvent(new Event('close'));
  }

  /** The text of all that it holds. */
  get text(): string {
    return [this.textContent, ...this.children.map(({ text }) => text)].join(' ').trim();
  }
}

let dialogs: FakeElement[];
let page: EventTarget;

beforeEach(() => {
  vi.useFakeTimers();
  dialogs = [];
  page = new EventTarget();
  vi.stubGlobal('document', {
    createElement: (name: string) => {
      const element = new FakeElement();
      if (name === 'dialog') dialogs.push(element);
      return element;
    },
    body: new FakeElement(),
  });
  vi.stubGlobal('addEventListener', page.addEventListener.bind(page));
});

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const shown = () => dialogs.filter(({ isShown }) => isShown);
/** The buttons of the question that is open. */
const answers = () => shown()[0].children[1].children;
const ask = (address = 'https://a.test/bunny.ply', signal = new AbortController().signal) =>
  askToFetch(address, signal);

test('only yes is yes: no, Escape and an earlier page’s withdrawal are not', async () => {
  for (const [value, isAgreed] of [
    ['yes', true],
    ['no', false],
    [undefined, false],
  ] as const) {
    const answer = ask();
    shown()[0].close(value);
    expect(await answer, String(value)).toBe(isAgreed);
    expect(shown()).toEqual([]);
  }
  const controller = new AbortController();
  const withdrawn = ask('https://a.test/a.ply', controller.signal);
  controller.abort();
  expect([await withdrawn, shown()]).toEqual([false, []]);
  expect(await ask('https://a.test/a.ply', AbortSignal.abort())).toBe(false);
  expect(shown()).toEqual([]);
});

test('a later question takes the place of an earlier one, whose answer is no', async () => {
  const first = ask('https://evil.test/a.ply');
  const second = ask('https://trusted.test/b.ply');
  expect(shown()).toHaveLength(1);
  expect(await first).toBe(false);
  expect(shown()[0].text).toContain('trusted.test');
  expect(shown()[0].text).toContain('File: b.ply');
  shown()[0].close('yes');
  expect(await second).toBe(true);
});

test('a grave question cannot be accepted at once, nor right after the window returns to the front', async () => {
  const answer = ask();
  const [yes, no] = answers();
  expect([yes.value, yes.disabled, no.value, no.disabled]).toEqual(['yes', true, 'no', false]);
  vi.advanceTimersByTime(599);
  expect(yes.disabled).toBe(true);
  vi.advanceTimersByTime(1);
  expect(yes.disabled).toBe(false);
  page.dispatchEvent(new Event('focus'));
  expect(yes.disabled).toBe(true);
  vi.advanceTimersByTime(600);
  expect(yes.disabled).toBe(false);
  shown()[0].close('no');
  await answer;
  page.dispatchEvent(new Event('focus'));
  expect([yes.disabled, vi.getTimerCount()]).toEqual([false, 0]);
  void askForStrokes(['dark.png']);
  expect(answers()[0].disabled).toBe(false);
});
