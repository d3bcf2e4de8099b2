import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { PARTS, type Part } from './contents.js';

const root = new URL('../../', import.meta.url);
const WIDTH = 78;

/** The text of NOTICE.txt: the licence of this project, and everything in the built page that others have made. */
export function writeNotice(): string {
  const sections = [
    'three-hatching, and what its pages are made of',
    '',
    'The page runs on your own computer, and sends nothing anywhere. This file names what',
    'it brings along, who made it, and under which terms.',
    '',
    ...PARTS.map(({ name, licence, by }) => `  ${`${name} `.padEnd(20, '.')} ${licence}; ${by}`),
    '',
    heading('three-hatching'),
    textOf('LICENSE'),
    ...PARTS.flatMap((part) => [heading(titleOf(part)), aboutOf(part), '', termsOf(part)]),
  ];
  return `${sections.join('\n')}\n`;
}

/** The same, as the table of docs/versions.md. */
export function licenceTable(): string {
  const rows = PARTS.map(
    ({ name, use, by, address, licence }) => `| [${name}](${address}) | ${use} | ${by} | ${licence} |`,
  );
  return ['| | for | by | licence |', '| --- | --- | --- | --- |', ...rows].join('\n');
}

function titleOf({ name, from }: Part): string {
  const path = from && `node_modules/${from}/package.json`;
  if (!path || !existsSync(new URL(path, root))) return name;
  return `${name} ${(JSON.parse(textOf(path)) as { version: string }).version}`;
}

const aboutOf = ({ use, by, address, licence }: Part): string =>
  [`For: ${use}`, `By: ${by}`, `From: ${address}`, `Licence: ${licence}`].join('\n');

function termsOf({ name, licenceFile, terms }: Part): string {
  if (licenceFile) return textOf(licenceFile);
  if (terms) return wrapped(terms);
  throw new Error(`writeNotice: "${name}" has neither a licence file nor terms; add one in tools/notice/contents.ts.`);
}

const heading = (text: string): string => `\n${'='.repeat(WIDTH)}\n${text}\n${'='.repeat(WIDTH)}\n`;

const textOf = (path: string): string => readFileSync(fileURLToPath(new URL(path, root)), 'utf8').trim();

function wrapped(text: string): string {
  const lines: string[] = [''];
  for (const word of text.split(' ')) {
    const line = lines[lines.length - 1];
    if (line && line.length + word.length >= WIDTH) lines.push(word);
    else lines[lines.length - 1] = line ? `${line} ${word}` : word;
  }
  return lines.join('\n');
}

/** Libraries that are copied into three.js are parts of their own in the notice. */
const CARRIED = /^(three\/examples\/jsm\/libs\/)/;

/**
 * The bundled modules, given by their paths, that no part of the notice names.
 *
 * @returns the name of each package, or the path of the file in it, once
 */
export function unnoticed(modules: Iterable<string>): string[] {
  const missing = new Set<string>();
  for (const module of modules) {
    const path = module
      .split('?')[0]
      .split(/[\\/]node_modules[\\/]/)
      .slice(1)
      .at(-1)
      ?.replaceAll('\\', '/');
    if (!path || PARTS.some(({ from }) => from && isIn(path, from))) continue;
    missing.add(CARRIED.test(path) ? path : path.split('/', path.startsWith('@') ? 2 : 1).join('/'));
  }
  return [...missing].sort();
}

const isIn = (path: string, from: string): boolean =>
  path === from || (path.startsWith(`${from}/`) && (!CARRIED.test(path) || CARRIED.test(from)));
