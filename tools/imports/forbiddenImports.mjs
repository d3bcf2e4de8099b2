import { readdirSync, readFileSync } from 'node:fs';
import { posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import { OFFERS } from './offers.mjs';
import { ROOMS, WITH_THREE, WITHOUT_THREE } from './rooms.mjs';

export const root = fileURLToPath(new URL('../..', import.meta.url));
const { dirname, join } = posix;

/** The folders whose imports are checked. */
const FOLDERS = ['src', 'examples', 'tools'];
const CODE = /\.(tsx?|mjs|js|css)$/;
const IMPORT = /(?:\bfrom|\bimport)\s*\(?\s*['"]([^'"\n]+)['"]/g;

/**
 * Every import that goes against the table of rooms, or from outside of the tests into them, and every file that a room offers to no one.
 *
 * @returns {string[]} a sentence for each
 */
export function forbiddenImports() {
  const imported = new Set();
  const objections = codeIn(FOLDERS).flatMap((file) =>
    [...readFileSync(`${root}${file}`, 'utf8').matchAll(IMPORT)].flatMap(([, name]) => {
      if (name.startsWith('.') && roomOf(file) !== roomOf(targetOf(file, name))) imported.add(targetOf(file, name));
      return objectionTo(file, name) ?? [];
    }),
  );
  const unused = Object.entries(OFFERS).flatMap(([room, files]) =>
    files
      .filter((file) => !imported.has(`src/${room}/${file}`))
      .map(
        (file) => `src/${room}/${file} is offered by ${room} and imported by no other room (tools/imports/offers.mjs).`,
      ),
  );
  return [...objections, ...unused];
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
  const room = roomOf(file);
  if (room !== undefined && !(room in ROOMS))
    return `${file} lies in no room: give ${room} a row in tools/imports/rooms.mjs.`;
  if (!name.startsWith('.')) {
    const isThree = name === 'three' || name.startsWith('three/');
    return isThree && knowsNoThree(file) ? `${file} imports ${name}: ${room} knows no three.js.` : undefined;
  }
  const target = targetOf(file, name);
  if (isIn(target, 'tests')) return `${file} imports ${name}: only tests import from tests.`;
  if (room === undefined || roomOf(target) === room) return undefined;
  if (!ROOMS[room].some((path) => isIn(target, path.startsWith('/') ? path.slice(1) : `src/${path}`)))
    return `${file} imports ${name}: ${room} imports ${ROOMS[room].join(', ') || 'no other room'} (tools/imports/rooms.mjs).`;
  const [, from, ...path] = target.split('/');
  // A room that is one file offers itself.
  if (isIn(target, 'src') && path.length > 0 && !OFFERS[from]?.includes(path.join('/')))
    return `${file} imports ${name}: ${from} does not offer ${path.join('/')} to other rooms (tools/imports/offers.mjs).`;
  return undefined;
}

/** The path from the root of what a file imports by a relative path. */
const targetOf = (file, name) => {
  const path = join(dirname(file), name.split('?')[0]);
  return path.endsWith('.js') && isIn(path, 'src') ? path.replace(/\.js$/, '.ts') : path;
};

/** The room of a path in `src`: its folder there, or the name of a file that lies in none. */
const roomOf = (path) => (isIn(path, 'src') ? path.split('/')[1] : undefined);

const knowsNoThree = (file) =>
  WITHOUT_THREE.some((path) => isIn(file, `src/${path}`)) && !WITH_THREE.some((path) => isIn(file, `src/${path}`));

const isIn = (path, folder) => path === folder || path.startsWith(`${folder}/`);
