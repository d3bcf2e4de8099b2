import { existsSync, readFileSync } from 'node:fs';
import { posix } from 'node:path';
import { expect, test } from 'vitest';
import { DOCUMENTS, root } from './documents.js';

/** The text without code, in which nothing is a link. */
const withoutCode = (text: string): string => text.replace(/^```[\s\S]*?^```/gm, '').replace(/`[^`\n]*`/g, '');

/** The anchors of the headings, as GitHub names them. */
function anchorsOf(text: string): string[] {
  const seen = new Map<string, number>();
  return [...text.replace(/^```[\s\S]*?^```/gm, '').matchAll(/^#+ (.+)$/gm)].map(([, heading]) => {
    const name = heading
      .toLowerCase()
      .replace(/\[([^\]]*)\]\([^)]*\)/g, '$1')
      .replace(/[^\p{L}\p{N}\s_-]/gu, '')
      .replace(/\s/g, '-');
    const times = seen.get(name) ?? 0;
    seen.set(name, times + 1);
    return times === 0 ? name : `${name}-${times}`;
  });
}

test.each(Object.keys(DOCUMENTS))('every link of %s leads somewhere', (path) => {
  const links = [...withoutCode(DOCUMENTS[path]).matchAll(/\]\(([^)\s]+)\)/g)].map(([, link]) => link);
  const broken = links.filter((link) => {
    if (/^(https?|mailto):/.test(link)) return false;
    const [file, anchor] = link.split('#');
    const target = file ? posix.join(posix.dirname(path), file) : path;
    if (!existsSync(`${root}${target}`)) return true;
    return anchor !== undefined && !anchorsOf(DOCUMENTS[target] ?? '').includes(anchor);
  });
  expect(broken).toEqual([]);
});

test('every guide can be reached from the README', () => {
  const reached = new Set(['README.md']);
  // A set that grows is gone through to its end.
  for (const path of reached) {
    for (const [, link] of withoutCode(DOCUMENTS[path]).matchAll(/\]\(([^)\s#]+\.md)/g)) {
      const target = posix.join(posix.dirname(path), link);
      if (target in DOCUMENTS) reached.add(target);
    }
  }
  const lost = Object.keys(DOCUMENTS).filter((path) => path.startsWith('docs/') && !reached.has(path));
  expect(lost).toEqual([]);
});

test('every page in the sidebar of the site is there, and every guide has a place in it', () => {
  const config = readFileSync(`${root}tools/site/.vitepress/config.ts`, 'utf8');
  const listed = [...config.matchAll(/group\(([^)]*)\)/g)].flatMap(([, names]) =>
    // After its title.
    [...names.matchAll(/'([^']+)'/g)].map(([, name]) => name).slice(1),
  );
  // Made by tools/site/build.mjs from other files.
  const made = ['examples', 'contributing', 'changelog', 'security'];
  const guides = Object.keys(DOCUMENTS).flatMap((path) => /^docs\/(.+)\.md$/.exec(path)?.[1] ?? []);
  expect(listed.filter((name) => !guides.includes(name) && !made.includes(name))).toEqual([]);
  expect(guides.filter((name) => !listed.includes(name))).toEqual([]);
});
