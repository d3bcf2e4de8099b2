import { BoxGeometry, BufferGeometry, Group, Mesh, type Object3D } from 'three';
import { applyHatching, bakeOcclusion } from 'three-hatching';
import { describe, expect, test } from 'vitest';
import { assertTree } from '../../../src/scene/assertTree.js';

const named = (name: string): Group => Object.assign(new Group(), { name });

describe('a scene that goes round', () => {
  const scenes: [string, () => Object3D, string][] = [
    [
      'below the root',
      () => {
        const root = named('root').add(named('a').add(named('b')));
        const [a] = root.children;
        a.children[0].children.push(a);
        return root;
      },
      '"a" at root/a',
    ],
    [
      'of an object that is its own child',
      () => {
        const root = named('root');
        root.children.push(root);
        return root;
      },
      '"root"',
    ],
    [
      'above the root',
      () => {
        const [outer, inner] = [named('outer'), named('inner')];
        outer.add(inner.add(new Mesh(new BoxGeometry())));
        inner.add(outer);
        return inner.children[0];
      },
      '"inner" at outer/inner',
    ],
  ];
  test.each(scenes)('%s is refused before anything follows it', async (_, make, name) => {
    const says = (caller: string) =>
      `${caller}: the Group ${name} is its own descendant, so the scene has a cycle. Remove it from the children of its descendants.`;
    expect(() => assertTree('test', make())).toThrow(says('test'));
    await expect(applyHatching(make(), { tonalArtMap: null })).rejects.toThrow(says('applyHatching'));
    await expect(bakeOcclusion(make())).rejects.toThrow(says('bakeOcclusion'));
  });
});

test('an object that stands in two places is no circle, nor is a deep scene', () => {
  const shared = named('shared');
  const root = named('root').add(named('a'), named('b'));
  for (const child of root.children) child.children.push(shared);
  expect(() => assertTree('test', root)).not.toThrow();
  let deepest: Object3D = root;
  for (let i = 0; i < 20_000; i++) {
    const child = new Group();
    child.parent = deepest;
    deepest.children.push(child);
    deepest = child;
  }
  expect(() => assertTree('test', root)).not.toThrow();
});

test.each([null, undefined, {}])('a child that is %s is refused', async (child) => {
  const root = named('root').add(named('a'));
  root.children[0].children.push(child as never);
  const says = 'child 0 of the Group "a" at root/a is not a THREE.Object3D. Remove it from the children.';
  await expect(applyHatching(root, { tonalArtMap: null })).rejects.toThrow(`applyHatching: ${says}`);
  await expect(bakeOcclusion(root)).rejects.toThrow(`bakeOcclusion: ${says}`);
});

test.each<[string, unknown]>([
  ['no geometry', null],
  ['something else for a geometry', {}],
  ['a geometry without attributes', Object.assign(new BufferGeometry(), { attributes: null })],
  ['a geometry without morph attributes', Object.assign(new BufferGeometry(), { morphAttributes: null })],
])('a mesh with %s is skipped in words of the function', async (_, geometry) => {
  const broken = Object.assign(new Mesh(), { geometry });
  const root = named('root').add(new Mesh(new BoxGeometry()), broken);
  const applied = await applyHatching(root, { tonalArtMap: null });
  const baked = await bakeOcclusion(root, { directions: 64 });
  for (const [caller, { skipped }] of Object.entries({ applyHatching: applied, bakeOcclusion: baked })) {
    expect(skipped.map(({ mesh }) => mesh)).toEqual([broken]);
    expect(skipped[0].error?.message).toMatch(new RegExp(`^${caller}: (expected a THREE|the geometry: \\w+ is null)`));
  }
});
