import { readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { DOCUMENTS, root } from './documents.js';

const guide = DOCUMENTS['docs/troubleshooting.md'];
/** The messages of the tables: the first cell of each row, as code. Those of other programs are in italics. */
const MESSAGES = [...guide.matchAll(/^\| `(.+?)` \|/gm)].map(([, message]) => message);

const source = readdirSync(`${root}src`, { recursive: true, encoding: 'utf8' })
  .filter((path) => path.endsWith('.ts') && !path.startsWith('demo'))
  .map((path) => readFileSync(`${root}src/${path}`, 'utf8'))
  .join('\n');

test('the guide lists messages', () => expect(MESSAGES.length).toBeGreaterThan(20));

test.each(MESSAGES)('the library says: %s', (message) => expect(source).toContain(message));
