import { expect, test } from 'vitest';
import { importAmd } from '../../../../src/playground/reading/loadDraco.js';

const script = (body: string) => `data:text/javascript,${encodeURIComponent(body)}`;
const holding = (value: string) => script(`var Held = '${value}'; if (define.amd) define([], () => Held);`);

test('each script delivers its own exports, and leaves no globals behind', async () => {
  const addresses = ['first', 'second', 'third'].map(holding);
  expect(await Promise.all([...addresses, addresses[0]].map(importAmd))).toEqual(['first', 'second', 'third', 'first']);
  expect(await importAmd(addresses[1])).toBe('second');
  expect(globalThis).not.toHaveProperty('define');
});

test('scripts that fail or export nothing reject, and later ones still load', async () => {
  const [failing, empty] = [script('throw new Error("broken")'), script('0')];
  const all = await Promise.allSettled([failing, empty, holding('last')].map(importAmd));
  expect(all.map((one) => (one.status === 'fulfilled' ? one.value : one.reason.message))).toEqual([
    'broken',
    `${empty} holds nothing`,
    'last',
  ]);
});

test('an AMD loader of the page is restored', async () => {
  const own = () => {};
  Object.assign(globalThis, { define: own });
  try {
    expect(await importAmd(holding('beside it'))).toBe('beside it');
    expect(globalThis).toHaveProperty('define', own);
  } finally {
    Reflect.deleteProperty(globalThis, 'define');
  }
});
