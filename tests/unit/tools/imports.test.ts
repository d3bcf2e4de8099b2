import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { posix } from 'node:path';
import { expect, test } from 'vitest';
import { codeIn, forbiddenImports, objectionTo, root } from '../../../tools/imports/forbiddenImports.mjs';
import { ROOMS } from '../../../tools/imports/rooms.mjs';

test('no file imports what its room may not, and nothing outside of the tests imports from them', () => {
  expect(forbiddenImports()).toEqual([]);
});

test('the table is a tower: a room imports only rooms that stand before it', () => {
  const before = new Set<string>();
  for (const [room, imports] of Object.entries<readonly string[]>(ROOMS)) {
    for (const name of imports.filter((path) => !path.startsWith('/')))
      expect(before.has(name), `${room} imports ${name}`).toBe(true);
    before.add(room);
  }
});

test('src has at most thirteen rooms, and CONTRIBUTING says what each is for', () => {
  const rooms = readdirSync(`${root}src`, { withFileTypes: true }).filter((entry) => entry.isDirectory());
  expect(rooms.length).toBeLessThanOrEqual(13);
  const map = readFileSync(`${root}CONTRIBUTING.md`, 'utf8');
  for (const { name } of rooms) expect(map).toContain(`\n| \`src/${name}\``);
});

test('no folder of src lies deeper than three below it, and none has one file or two', () => {
  const files = readdirSync(`${root}src`, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => posix.join('src', posix.relative(`${root}src`, entry.parentPath), entry.name));
  const folders = new Map<string, number>();
  for (const file of files) folders.set(posix.dirname(file), (folders.get(posix.dirname(file)) ?? 0) + 1);
  expect(files.length).toBeGreaterThan(300);
  expect([...folders.keys()].filter((folder) => folder.split('/').length > 4)).toEqual([]);
  const small = [...folders]
    .filter(([folder, count]) => !/^src($|\/playground\/models\/)/.test(folder) && count < 3)
    .map(([folder]) => folder);
  expect(small).toEqual([]);
});

test.each([
  ['src/mesh/weldPositions.ts', '../strokes/random.js', 'mesh imports no other room'],
  ['src/mesh/weldPositions.ts', 'three/addons/loaders/GLTFLoader.js', 'mesh knows no three.js'],
  ['src/vector/shading/tone.ts', 'three', 'vector knows no three.js'],
  ['src/material/FrameStamp.ts', '../scene/applyHatching.js', 'material imports'],
  ['src/viewer/files/readModel.ts', '../../index.js', 'viewer imports'],
  ['src/react/Hatcher.ts', '../scene/applyHatching.js', 'react imports no other room'],
  [
    'src/scene/applyHatching.ts',
    '../material/deformation/PrePass.js',
    'material does not offer deformation/PrePass.ts',
  ],
  ['src/playground/main.ts', '../viewer/files/gltf/readGltf.js', 'viewer does not offer files/gltf/readGltf.ts'],
  ['src/newRoom/file.ts', './other.js', 'src/newRoom/file.ts lies in no room'],
  ['tools/soak/soak.ts', '../../tests/browser/test.js', 'only tests import from tests'],
])('%s may not import %s', (file, name, reason) => {
  expect(objectionTo(file, name)).toContain(reason);
});

test.each([
  ['src/mesh/weldPositions.ts', './TriangleMesh.js'],
  ['src/mesh/bake/bake.ts', '../TriangleMesh.js'],
  ['src/material/outlines/HatchingOutlines.ts', '../tam/toothMap.js'],
  ['src/material/outlines/HatchingOutlines.ts', '../../../shaders/outlines/outline.vert?raw'],
  ['src/material/outlines/HatchingOutlines.ts', '../../mesh/TriangleMesh.js'],
  ['src/viewer/files/gltf/readGltf.ts', '../scenes/mergeScene.js'],
  ['src/playground/panel/SettingsPanel.ts', '../main.js'],
  ['src/vector/svg/drawSVG.ts', 'three'],
  ['src/scene/applyHatching.ts', 'three'],
])('%s may import %s', (file, name) => {
  expect(objectionTo(file, name)).toBeUndefined();
});

test('every module that tools and tests load by its path is there', () => {
  const missing = codeIn(['tools', 'tests', 'examples']).flatMap((file) =>
    [...readFileSync(`${root}${file}`, 'utf8').matchAll(/ssrLoadModule\(\s*'\/([^']+)'/g)]
      .filter(([, path]) => !existsSync(`${root}${path}`))
      .map(([, path]) => `${file} loads ${path}`),
  );
  expect(missing).toEqual([]);
});
