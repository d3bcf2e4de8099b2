import { existsSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { codeIn, forbiddenImports, objectionTo, root } from '../../../tools/imports/forbiddenImports.mjs';
import { ROOMS } from '../../../tools/imports/rooms.mjs';

test('no file imports what its room may not, and nothing outside of the tests imports from them', () => {
  expect(forbiddenImports()).toEqual([]);
});

test('the table is a tower: a room imports only rooms that stand before it', () => {
  const before = new Set<string>();
  for (const [room, imports] of Object.entries<readonly string[]>(ROOMS)) {
    const around = room.slice(0, room.lastIndexOf('/') + 1);
    for (const name of imports.filter((path) => !path.startsWith('/'))) {
      const known = [...before].some(
        (path) => `${around}${name}` === path || `${around}${name}`.startsWith(`${path}/`),
      );
      expect(known, `${room} imports ${name}`).toBe(true);
    }
    before.add(room);
  }
});

test.each([
  ['src/mesh/weldPositions.ts', '../mesh/bake/bake.js', 'mesh imports slices'],
  ['src/mesh/weldPositions.ts', 'three/addons/loaders/GLTFLoader.js', 'mesh knows no three.js'],
  ['src/material/FrameStamp.ts', '../scene/applyHatching.js', 'material imports'],
  ['src/viewer/files/formats/readPly.ts', '../../demo/stage/View.js', 'files/ply imports common'],
  ['src/viewer/files/readPly.ts', '../index.js', 'files imports no other room'],
  ['src/viewer/files/gltf/readGltf.ts', '../ply/readPly.js', 'files/gltf imports common'],
  ['src/viewer/files/gltf/readGltf.ts', '../readModel.js', 'files/gltf imports common'],
  ['src/playground/panel/SettingsPanel.ts', '../dialogs/Gallery.js', 'demo/playground/panel imports'],
  ['src/playground/panel/SettingsPanel.ts', '../main.js', 'demo/playground/panel imports'],
  ['src/react/Hatcher.tsx', '../scene/applyHatching.js', 'react imports no other room'],
  ['src/material/outlines/HatchingOutlines.ts', '../material/tam/TonalArtMap.js', 'outlines imports'],
  ['tools/soak/soak.ts', '../../tests/browser/test.js', 'only tests import from tests'],
])('%s may not import %s', (file, name, reason) => {
  expect(objectionTo(file, name)).toContain(reason);
});

test.each([
  ['src/mesh/weldPositions.ts', './TriangleMesh.js'],
  ['src/mesh/bake/bake.ts', '../mesh/TriangleMesh.js'],
  ['src/material/outlines/HatchingOutlines.ts', '../material/tam/toothMap.js'],
  ['src/material/outlines/HatchingOutlines.ts', '../../shaders/outlines/outline.vert?raw'],
  ['src/viewer/files/gltf/readGltf.ts', '../scenes/mergeScene.js'],
  ['src/viewer/files/readModel.ts', './ply/readPly.js'],
  ['src/playground/panel/SettingsPanel.ts', '../../../settings/settings.js'],
  ['src/playground/createPlayground.ts', './panel/SettingsPanel.js'],
  ['src/scene/applyHatching.ts', 'three'],
])('%s may import %s', (file, name) => {
  expect(objectionTo(file, name)).toBeUndefined();
});

test('a folder that has no row is told to get one', () => {
  expect(() => objectionTo('src/newRoom/file.ts', '../mesh/TriangleMesh.js')).toThrow(
    'newRoom/file.ts lies in no room',
  );
});

test('every module that tools and tests load by its path is there', () => {
  const missing = codeIn(['tools', 'tests', 'examples']).flatMap((file) =>
    [...readFileSync(`${root}${file}`, 'utf8').matchAll(/ssrLoadModule\(\s*'\/([^']+)'/g)]
      .filter(([, path]) => !existsSync(`${root}${path}`))
      .map(([, path]) => `${file} loads ${path}`),
  );
  expect(missing).toEqual([]);
});
