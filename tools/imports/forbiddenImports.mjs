import { readdirSync, readFileSync } from 'node:fs';
import { posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import { ROOMS, WITHOUT_THREE } from './rooms.mjs';

export const root = fileURLToPath(new URL('../..', import.meta.url));
const { dirname, join } = posix;

/** The folders whose imports are checked. */
const FOLDERS = ['src', 'examples', 'tools'];
const CODE = /\.(tsx?|mjs|js|css)$/;
const IMPORT = /(?:\bfrom|\bimport)\s*\(?\s*['"]([^'"\n]+)['"]/g;

/**
 * Every import that goes against the table of rooms, or from outside of the tests into them.
 *
 * @returns {string[]} a sentence for each
 */
export function forbiddenImports() {
  return codeIn(FOLDERS).flatMap((file) =>
    [...readFileSync(`${root}${file}`, 'utf8').matchAll(IMPORT)].flatMap(([, name]) => objectionTo(file, name) ?? []),
  );
}

/**
 * Every file of code in some folders, as its path from the root.
 *
 * @param {readonly string[]} folders
 */
export function codeIn(folders) {
  return folders.flatMap((folder) =>
    readdirSync(`${root}${folder}`, { recursive: true })
      .map((path) => `${folder}/${String(path).replaceAll('\\', '/')}`)
      .filter((path) => CODE.test(path) && !/\/(node_modules|output)\//.test(path)),
  );
}

/**
 * Why a file may not import a module, or undefined if it may.
 *
 * @param {string} file - its path from the root
 * @param {string} name - as written in the import
 * @returns {string | undefined}
 */
export function objectionTo(file, name) {
  const room = file.startsWith('src/') ? roomOf(file.slice('src/'.length)) : undefined;
  if (!name.startsWith('.')) {
    const isThree = name === 'three' || name.startsWith('three/');
    return isThree && WITHOUT_THREE.includes(room) ? `${file} imports ${name}: ${room} knows no three.js.` : undefined;
  }
  const target = join(dirname(file), name.split('?')[0].replace(/\.js$/, '.ts'));
  if (isIn(target, 'tests')) return `${file} imports ${name}: only tests import from tests.`;
  if (room === undefined || isIn(target, `src/${room}`) || reachable(room).some((path) => isIn(target, path)))
    return undefined;
  return `${file} imports ${name}: ${room} imports ${ROOMS[room].join(', ') || 'no other room'} (tools/imports/rooms.mjs).`;
}

/** The innermost room that has the file. */
function roomOf(path) {
  const rooms = Object.keys(ROOMS).filter((room) => isIn(path, room));
  if (rooms.length === 0)
    throw new Error(`forbiddenImports: src/${path} lies in no room of tools/imports/rooms.mjs; give its folder a row.`);
  return rooms.reduce((inner, room) => (room.length > inner.length ? room : inner));
}

/** The paths from the root that a room may import, its surroundings' included. */
function reachable(room) {
  const around = dirname(room);
  const own = ROOMS[room].map((name) => (name.startsWith('/') ? name.slice(1) : join('src', around, name)));
  return around in ROOMS ? [...own, ...reachable(around)] : own;
}

const isIn = (path, folder) => path === folder || path.startsWith(`${folder}/`);
