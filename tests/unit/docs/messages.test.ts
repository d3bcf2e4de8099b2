import { readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { SENTENCES, type Sentence } from '../../../src/material/firstDraw/sentences.js';
import { DOCUMENTS, root } from './documents.js';

const guide = DOCUMENTS['docs/troubleshooting.md'];
/** The first cells of the rows of a text, as code. Those of other programs are in italics. */
const messagesOf = (text: string) => [...text.matchAll(/^\| `(.+?)` \|/gm)].map(([, message]) => message);

const [firstDraw, others] = guide.split('## Nothing is hatched');
const MESSAGES = messagesOf(others);

const source = readdirSync(`${root}src`, { recursive: true, encoding: 'utf8' })
  .filter((path) => /\.tsx?$/.test(path) && !path.startsWith('playground'))
  .map((path) => readFileSync(`${root}src/${path}`, 'utf8'))
  .join('\n');

test('the guide lists messages', () => expect(MESSAGES.length).toBeGreaterThan(20));

test.each(MESSAGES)('the library says: %s', (message) => expect(source).toContain(message));

test('the guide lists every sentence of the first draw, and no other', () => {
  const sentences = Object.values<Sentence>(SENTENCES).map((sentence) => sentence('…', '…', '…', '…'));
  expect(messagesOf(firstDraw)).toEqual(sentences);
});
