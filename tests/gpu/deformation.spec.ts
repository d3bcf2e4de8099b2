import { expect, test } from '../browser/test.js';
import { covered, difference } from './pixels.js';

/** Meshes with skins and morph targets: the layout `pull`, the pre-pass, and strokes that stay on the surface. */

test.beforeEach(async ({ page }) => {
  await page.goto('tests/gpu/deforming.html');
  await page.waitForFunction(() => window.deforming !== undefined);
});

for (const technique of ['triangle', 'adjacency'] as const) {
  test(`the layouts pull and corner draw the same pixels: ${technique}`, async ({ page }) => {
    const pictures = await page.evaluate(async (technique) => {
      const { THREE, HatchingMaterial, prepareHatchingGeometry, stripedMap, sceneOf, sun, pixelsOf, makeRenderer } =
        window.toolkit;
      const renderer = makeRenderer();
      const sheet = new THREE.PlaneGeometry(2, 2, 9, 9);
      for (let i = 0; i < 100; i++) sheet.attributes.position!.setZ(i, 0.4 * Math.sin(5 * i));
      sheet.deleteAttribute('normal');
      const grouped = new THREE.BoxGeometry(1, 1, 1, 3, 3, 3).toNonIndexed();
      const tonalArtMap = stripedMap();
      const pictures: number[][][] = [];
      for (const source of [new THREE.TorusKnotGeometry(0.6, 0.25, 80, 14), sheet, grouped]) {
        for (const toneNormal of ['face', 'smooth'] as const) {
          const material = new HatchingMaterial({
            tonalArtMap,
            technique,
            toneNormal,
            strokeScale: 2,
            side: THREE.DoubleSide,
          });
          const pair: number[][] = [];
          for (const layout of ['corner', 'pull'] as const) {
            const geometry = await prepareHatchingGeometry(source, { layout });
            const mesh = new THREE.Mesh(geometry, source === grouped ? source.groups.map(() => material) : material);
            mesh.rotation.set(0.4, 0.7, 0);
            pair.push(pixelsOf(sceneOf(mesh, sun()), renderer));
          }
          pictures.push(pair);
        }
      }
      return pictures;
    }, technique);
    expect(pictures).toHaveLength(6);
    for (const [corner, pull] of pictures) {
      expect(covered(corner!)).toBeGreaterThan(1500);
      expect(new Set(corner!).size).toBeGreaterThan(10);
      expect(difference(corner!, pull!)).toBe(0);
    }
  });
}

test('the pre-pass writes what three.js computes on the processor: skin, morph targets and both', async ({ page }) => {
  const worst = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, prepareHatchingGeometry, greyMap, sceneOf, sun, pixelsOf, makeRenderer } =
      window.toolkit;
    const { tubeGeometry, addMorphTargets, onBones, deviation } = window.deforming;
    const renderer = makeRenderer();
    const material = new HatchingMaterial({ tonalArtMap: greyMap() });
    const results: Record<string, ReturnType<typeof deviation>> = {};
    const show = (name: string, mesh: Parameters<typeof deviation>[1]) => {
      pixelsOf(sceneOf(mesh, sun()), renderer);
      results[name] = deviation(renderer, mesh);
    };
    for (const kind of ['skin', 'relative targets', 'absolute targets', 'skin and targets'] as const) {
      const source = tubeGeometry();
      if (kind !== 'skin') addMorphTargets(source, kind !== 'absolute targets');
      const geometry = await prepareHatchingGeometry(source);
      const isSkinned = kind.startsWith('skin');
      const mesh = isSkinned ? onBones(geometry, material) : new THREE.Mesh(geometry, material);
      if (isSkinned) (mesh as ReturnType<typeof onBones>).skeleton.bones[1]!.rotation.set(0.3, 0.2, 1.1);
      if (kind !== 'skin') mesh.morphTargetInfluences!.splice(0, 2, 0.7, -0.4);
      show(kind, mesh);
    }
    return results;
  });
  expect(Object.keys(worst)).toHaveLength(4);
  for (const [kind, { position, normal, moved }] of Object.entries(worst)) {
    expect(moved, `${kind}: movement`).toBeGreaterThan(0.05);
    expect(position, `${kind}: position`).toBeLessThanOrEqual(1e-5);
    expect(normal, `${kind}: normal`).toBeLessThanOrEqual(1e-5);
  }
});
