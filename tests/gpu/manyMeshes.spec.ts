import { expect } from '../browser/test.js';
import { covered } from './pixels.js';
import { test } from './toolkitPage.js';

/** Many meshes, materials and renderers on one page. three.js uploads the uniforms of a material once for all its meshes in a row. */

test('meshes that share a material are drawn as with one for each, whatever is drawn between them, by each of two renderers and cameras', async ({
  page,
}) => {
  const rounds = await page.evaluate(async () => {
    const {
      THREE,
      UsersMaterial,
      prepareHatchingGeometry,
      stripedMap,
      sceneOf,
      sun,
      makeRenderer,
      makeCamera,
      pixelsOf,
    } = window.toolkit;
    const geometry = await prepareHatchingGeometry(new THREE.TorusGeometry(0.32, 0.16, 12, 20), { layout: 'indexed' });
    const picture = new THREE.DataTexture(new Uint8Array([200, 90, 40, 255]), 1, 1);
    picture.needsUpdate = true;
    const plain = new THREE.MeshLambertMaterial({ map: picture });
    const engraving = new UsersMaterial({ preset: 'engraving', composition: { exposure: 1 } });
    // The same program, and other values: a program keeps those that were uploaded last.
    const coarser = new UsersMaterial({
      preset: 'engraving',
      composition: { exposure: 1 },
      lineSpacing: 9,
      ink: 'maroon',
    });
    const pencil = new UsersMaterial({ preset: 'pencil', composition: { exposure: 1 }, tonalArtMap: stripedMap() });
    const order = [
      engraving,
      engraving,
      pencil,
      engraving,
      plain,
      engraving,
      coarser,
      engraving,
      engraving,
      coarser,
      pencil,
    ];
    const sceneWith = (isShared: boolean) => {
      const meshes = order.map((material, i) => {
        const mesh = new THREE.Mesh(geometry, isShared ? material : material.clone());
        mesh.position.set((i % 4) * 0.8 - 1.2, Math.floor(i / 4) * 0.8 - 0.8, 0);
        mesh.rotation.set(i, 2 * i, 0);
        mesh.renderOrder = i;
        // Lines in a frame of the mesh's own, but for some; and some matter less.
        if (i % 5 !== 3)
          mesh.userData.hatchingField = new THREE.Matrix4()
            .makeRotationZ(i)
            .setPosition(i / 7, 0, 0)
            .toArray();
        if (i % 3 === 1) mesh.userData.hatching = { importance: 0.4 };
        return mesh;
      });
      return sceneOf(sun(), ...meshes);
    };
    const shared = sceneWith(true);
    const apart = sceneWith(false);
    const side = makeCamera();
    side.position.set(1, 0.5, 3.8);
    side.lookAt(0, 0, 0);
    const [renderer, other] = [makeRenderer(), makeRenderer()];
    const rounds: { shared: number[]; apart: number[] }[] = [];
    for (const [by, from] of [
      [renderer, makeCamera()],
      [other, makeCamera()],
      [renderer, side],
      [other, side],
      [renderer, makeCamera()],
    ] as const) {
      rounds.push({ shared: pixelsOf(shared, by, from), apart: pixelsOf(apart, by, from) });
    }
    // A value that is set counts for all meshes from the next frame on.
    for (const scene of [shared, apart])
      scene.traverse((object) => {
        if (!(object instanceof THREE.Mesh) || !('preset' in object.material)) return;
        object.material.tilesPerObjectUnit = 1.7;
      });
    rounds.push({ shared: pixelsOf(shared, renderer), apart: pixelsOf(apart, renderer) });
    return rounds;
  });
  for (const { shared, apart } of rounds) {
    expect(covered(apart)).toBeGreaterThan(1500);
    expect(shared).toEqual(apart);
  }
  expect(rounds[5].shared).not.toEqual(rounds[0].shared);
});

test('fifty materials of three presets, their clones among them, are drawn by three programs, in each renderer', async ({
  page,
}) => {
  const counts = await page.evaluate(async () => {
    const { THREE, UsersMaterial, prepareHatchingGeometry, stripedMap, sceneOf, sun, makeRenderer, makeCamera } =
      window.toolkit;
    const geometry = await prepareHatchingGeometry(new THREE.IcosahedronGeometry(0.2), { layout: 'indexed' });
    const tonalArtMap = stripedMap();
    const firsts = (['pen', 'engraving', 'pencil'] as const).map(
      (preset) => new UsersMaterial({ preset, composition: { exposure: 1 }, tonalArtMap }),
    );
    const materials = Array.from({ length: 50 }, (_, i) => {
      const material =
        i < 25
          ? firsts[i % 3].clone()
          : new UsersMaterial({
              preset: (['pen', 'engraving', 'pencil'] as const)[i % 3],
              composition: { exposure: 1 },
              tonalArtMap,
            });
      material.setValues({ ink: new THREE.Color().setHSL(i / 50, 1, 0.3), opacity: 1 });
      material.highlightThreshold = 0.01 * (i % 7);
      material.crossAngle = 1 + 0.01 * i;
      return material;
    });
    const scene = sceneOf(
      sun(),
      ...materials.map((material, i) => {
        const mesh = new THREE.Mesh(geometry, material);
        mesh.position.set((i % 8) * 0.3 - 1, Math.floor(i / 8) * 0.3 - 1, 0);
        return mesh;
      }),
    );
    return [makeRenderer(), makeRenderer()].map((renderer) => {
      const count = () => {
        renderer.render(scene, makeCamera());
        return renderer.info.programs!.length;
      };
      const first = count();
      for (const material of materials) material.highlightSoftness = 0.5;
      return [first, count(), count()];
    });
  });
  expect(counts).toEqual([
    [3, 3, 3],
    [3, 3, 3],
  ]);
});
