import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

/** Warnings on the first draw with a real renderer; tests/unit/material/firstDraw has all of them. */

test('an ordinary scene is drawn without warnings, and mistakes are reported once, whatever is drawn afterwards', async ({
  page,
  pageProblems,
}) => {
  await page.evaluate(async () => {
    const { THREE, HatchingMaterial, greyMap, sceneOf, sun, pixelsOf, makeRenderer, whenChecked } = window.toolkit;
    HatchingMaterial.silent = false;
    const renderer = makeRenderer();
    const ball = (parameters = {}) => {
      const material = new HatchingMaterial({ technique: 'hatching', tonalArtMap: greyMap(), ...parameters });
      return Object.assign(new THREE.Mesh(new THREE.SphereGeometry(), material), { name: 'ball' });
    };
    pixelsOf(sceneOf(ball(), sun()), renderer);
    await whenChecked();
    const dark = sceneOf(ball({ tonalArtMap: null, toneMapped: true }), sun(0.5));
    renderer.toneMapping = THREE.ACESFilmicToneMapping;
    for (let frame = 0; frame < 3; frame++) {
      pixelsOf(dark, renderer);
      await whenChecked();
    }
  });
  expect(pageProblems.splice(0)).toEqual([
    expect.stringContaining('the Mesh "ball" at Scene/ball is drawn without strokes'),
    expect.stringContaining('the Mesh "ball" at Scene/ball is drawn with the tone mapping of the renderer'),
    expect.stringContaining('the Mesh "ball" at Scene/ball gets too little light: its lights add up to 0.5.'),
  ]);
});
