import type { BufferGeometry } from 'three';
import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { centre, covered, difference, differing } from './pixels.js';
import { kindsOfTechnique } from './techniques.js';
import { test } from './toolkitPage.js';

/** Prepared geometry that was damaged before the bake, or changed, merged or exported after it. */

for (const technique of kindsOfTechnique) {
  test(
    `a mesh whose normals are NaN or zero is not black: ${technique}`,
    quickIf(technique === 'engraving'),
    async ({ page }) => {
      const [sound, ...broken] = await page.evaluate(async (technique) => {
        const { THREE, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
        const draw = async (bad: number | undefined) => {
          const geometry = new THREE.SphereGeometry(1, 24, 16);
          if (bad !== undefined) (geometry.getAttribute('normal').array as Float32Array).fill(bad);
          const mesh = await hatchedMesh(geometry, { technique, toneNormal: 'smooth' });
          return pixelsOf(sceneOf(mesh, sun(Math.PI, [0, 0, 1])));
        };
        return [await draw(undefined), await draw(Number.NaN), await draw(0)];
      }, technique);
      expect(covered(sound)).toBeGreaterThan(2000);
      expect(centre(sound)[0]).toBeGreaterThan(240);
      // Computed normals are not quite those that three gives its sphere.
      for (const pixels of broken) expect(differing(sound, pixels, 8)).toBeLessThan(0.01 * covered(sound));
    },
  );
}

test('geometry that is moved after the bake is named, once, with the remedy', async ({ page, pageProblems }) => {
  await page.evaluate(async () => {
    const {
      THREE,
      prepareHatchingGeometry,
      HatchingMaterial,
      greyMap,
      sceneOf,
      sun,
      pixelsOf,
      makeRenderer,
      whenChecked,
    } = window.toolkit;
    HatchingMaterial.silent = false;
    const renderer = makeRenderer();
    const tonalArtMap = greyMap();
    const draw = async (geometry: BufferGeometry, technique: 'adjacency' | 'hatching') => {
      const mesh = new THREE.Mesh(geometry, new HatchingMaterial({ technique, tonalArtMap }));
      mesh.name = geometry.name;
      const scene = sceneOf(mesh, sun());
      pixelsOf(scene, renderer);
      pixelsOf(scene, renderer);
      await whenChecked();
    };
    const prepare = async (name: string, layout: 'corner' | 'pull' | 'indexed') => {
      const geometry = await prepareHatchingGeometry(new THREE.BoxGeometry(), { layout });
      geometry.name = name;
      return geometry;
    };
    await draw(await prepare('untouched', 'corner'), 'adjacency');
    const cloned = (await prepare('cloned', 'pull')).clone();
    await draw(cloned, 'adjacency');
    await draw(cloned.rotateX(1), 'adjacency');
    await draw((await prepare('moved', 'corner')).translate(0, 1, 0), 'adjacency');
    const sameAgain = await prepare('sameAgain', 'corner');
    sameAgain.setAttribute('position', sameAgain.getAttribute('position').clone());
    await draw(sameAgain, 'hatching');
    const moved = () => new THREE.SphereGeometry().toNonIndexed().getAttribute('position');
    const replaced = await prepare('replaced', 'corner');
    await draw(replaced, 'hatching');
    replaced.setAttribute('position', moved());
    await draw(replaced, 'hatching');
    const replacedInClone = (await prepare('replacedInClone', 'pull')).clone();
    replacedInClone.setAttribute('position', moved());
    await draw(replacedInClone, 'adjacency');
    const indexed = (await prepare('indexed', 'indexed')).scale(1, 2, 1);
    await draw(indexed, 'hatching');
    const freed = (await prepare('freed', 'indexed')).center().deleteAttribute('hatchNormal');
    await draw(freed, 'hatching');
  });
  const problems = pageProblems.splice(0);
  const named = problems.map(
    (problem) => /positions of the Mesh "(\w+)".* have changed since it was prepared/.exec(problem)?.[1],
  );
  expect(named).toEqual(['cloned', 'moved', 'replaced', 'replacedInClone', 'indexed']);
  for (const problem of problems.slice(0, 4)) expect(problem).toContain('Move the mesh instead of the geometry');
  expect(problems[4]).toContain("geometry.deleteAttribute('hatchNormal')");
});

test('geometry without its adjacency is reported with its remedy', async ({ page, pageProblems }) => {
  const merged = await page.evaluate(async () => {
    const { THREE, mergeGeometries, prepareHatchingGeometry, hatchedMesh, greyMap, HatchingMaterial, sceneOf, sun } =
      window.toolkit;
    const { pixelsOf, makeRenderer, whenChecked } = window.toolkit;
    const renderer = makeRenderer();
    HatchingMaterial.silent = false;
    const draw = (geometry: BufferGeometry) => {
      const mesh = new THREE.Mesh(geometry, new HatchingMaterial({ tonalArtMap: greyMap() }));
      mesh.name = geometry.name;
      return pixelsOf(sceneOf(mesh, sun()), renderer);
    };
    const indexed = await prepareHatchingGeometry(new THREE.BoxGeometry(), { layout: 'indexed' });
    indexed.name = 'indexed';
    draw(indexed);
    await whenChecked();
    const halves = (layout: 'corner' | 'pull') =>
      Promise.all(
        [-0.7, 0.7].map((x) =>
          prepareHatchingGeometry(new THREE.BoxGeometry(0.8, 0.8, 0.8).translate(x, 0, 0), { layout }),
        ),
      );
    const pulled = mergeGeometries(await halves('pull'));
    pulled.name = 'pulled';
    draw(pulled);
    await whenChecked();
    const source = mergeGeometries([-0.7, 0.7].map((x) => new THREE.BoxGeometry(0.8, 0.8, 0.8).translate(x, 0, 0)));
    return {
      expected: pixelsOf(sceneOf(await hatchedMesh(source), sun()), renderer),
      // The remedy that the message names.
      preparedAgain: draw(await prepareHatchingGeometry(pulled, { adjacency: true })),
      corner: draw(mergeGeometries(await halves('corner'))),
    };
  });
  expect(covered(merged.expected)).toBeGreaterThan(800);
  expect(difference(merged.expected, merged.preparedAgain)).toBe(0);
  expect(difference(merged.expected, merged.corner)).toBe(0);
  const problems = pageProblems.splice(0);
  const remedy = "Prepare it with { adjacency: true }, or use the technique 'hatching'.";
  expect(problems).toEqual([
    expect.stringContaining(`the Mesh "indexed" at Scene/indexed was prepared without triangle adjacency. ${remedy}`),
    expect.stringContaining('the Mesh "pulled" at Scene/pulled has lost its triangle adjacency'),
  ]);
  expect(problems[1]).toContain(remedy);
});

test('GLTFExporter writes the scene after restore(); exported hatched meshes can be hatched again', async ({
  page,
  pageProblems,
}) => {
  const { before, after, hatched, expected, again, names } = await page.evaluate(async () => {
    const { THREE, GLTFExporter, GLTFLoader, applyHatching, greyMap, sceneOf, sun, pixelsOf, makeRenderer } =
      window.toolkit;
    const renderer = makeRenderer();
    const root = new THREE.Group().add(
      new THREE.Mesh(new THREE.TorusGeometry(0.8, 0.4, 12, 24), new THREE.MeshStandardMaterial({ color: 'red' })),
    );
    const write = async () => JSON.stringify(await new GLTFExporter().parseAsync(root));
    const before = await write();
    const hatching = await applyHatching(root, {
      layout: 'corner',
      tonalArtMap: greyMap(),
      material: { color: 'white' },
    });
    const expected = pixelsOf(sceneOf(root, sun()), renderer);
    const hatched = await write();
    root.removeFromParent();
    hatching.restore();
    const after = await write();
    const { scene } = await new GLTFLoader().parseAsync(hatched, '');
    await applyHatching(scene, { tonalArtMap: greyMap(), material: { color: 'white' } });
    const again = pixelsOf(sceneOf(scene, sun()), renderer);
    let names: string[] = [];
    scene.traverse((object) => {
      if (object instanceof THREE.Mesh) names = Object.keys(object.geometry.attributes);
    });
    return { before, after, hatched, expected, again, names };
  });
  expect(after).toBe(before);
  expect(hatched).not.toBe(before);
  expect(covered(expected)).toBeGreaterThan(800);
  expect(differing(expected, again, 2)).toBeLessThan(0.01 * covered(expected));
  expect(names.filter((name) => name.startsWith('_'))).toEqual([]);
  expect(pageProblems.splice(0)).toEqual([expect.stringContaining('GLTFExporter: THREE.ShaderMaterial not supported')]);
});
