import { PRESET_MATERIALS } from '../../src/look/presetMaterials.js';
import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

/** Dry media: pencil, charcoal, chalk. A wall that fills the picture, in tones that the light makes. */

const MEDIA = [
  { paperGrain: 0.4, paperGrainSize: 1.6, softness: 0.9, smudge: 0.2 },
  { paperGrain: 0.6, paperGrainSize: 3.7, softness: 0.3, smudge: 0.5 },
  { paperGrain: 1, paperGrainSize: 2.5, softness: 0, smudge: 0 },
  { paperGrain: 0.6, paperGrainSize: 10, softness: 0.5, smudge: 0.2 },
  { paperGrain: 0, paperGrainSize: 2.5, softness: 0.5, smudge: 0 },
  { paperGrain: 0.5, paperGrainSize: 2.5, softness: 1, smudge: 1 },
];

test('the mean ink of a dry medium is the tone, and mostly grey at middle tones', async ({ page }, testInfo) => {
  const found = await page.evaluate(async (media) => {
    const { THREE, TonalArtMap, hatchedMesh, makeRenderer, sceneOf, sun } = window.toolkit;
    const side = 256;
    const tonalArtMap = await TonalArtMap.generate({ size: 128 });
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(40, 40), {
      technique: 'dryMedia',
      tonalArtMap,
      tilesPerObjectUnit: 2,
    });
    const light = sun();
    const scene = sceneOf(mesh, light);
    const camera = new THREE.PerspectiveCamera(90, 1, 0.1, 100);
    const renderer = makeRenderer();
    renderer.setSize(side, side, false);
    const gl = renderer.getContext();
    const pixels = new Uint8Array(side * side * 4);
    const errors: string[] = [];
    let worst = 0;
    const greys: number[] = [];
    // Near, where strokes are drawn, and far, where they are too fine.
    for (const away of [1, 9]) {
      for (const medium of media) {
        Object.assign(mesh.material, medium);
        for (const tone of [0.1, 0.3, 0.5, 0.75, 0.95]) {
          light.position.set(Math.sqrt(1 - (1 - tone) ** 2), 0, 1 - tone);
          let ink = 0;
          let grey = 0;
          for (const x of [0, 2.1]) {
            camera.position.set(x, 0, away);
            renderer.render(scene, camera);
            gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
            for (let i = 0; i < pixels.length; i += 4) {
              ink += 1 - pixels[i] / 255;
              grey += Number(pixels[i] > 12 && pixels[i] < 243);
            }
          }
          const error = ink / (2 * side * side) - tone;
          worst = Math.max(worst, Math.abs(error));
          errors.push(error.toFixed(3));
          if (tone === 0.5 && medium === media[0]) greys.push(grey / (2 * side * side));
        }
      }
    }
    return { errors, worst, greys };
  }, MEDIA);
  testInfo.annotations.push({ type: 'tone error', description: found.errors.join(', ') });
  expect(found.worst, found.errors.join()).toBeLessThan(0.02);
  for (const grey of found.greys) expect(grey).toBeGreaterThan(0.5);
});

test('the tooth stays with the sheet, the strokes with the model; tiles of a picture have one tooth', async ({
  page,
}) => {
  const found = await page.evaluate(async () => {
    const { THREE, TonalArtMap, hatchedMesh, makeRenderer, sceneOf, sun } = window.toolkit;
    const side = 128;
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(40, 40), {
      technique: 'dryMedia',
      tonalArtMap: await TonalArtMap.generate({ size: 128 }),
      softness: 0.5,
    });
    const light = sun();
    light.position.set(1, 0, 0.7);
    const scene = sceneOf(mesh, light);
    const camera = new THREE.PerspectiveCamera(90, 1, 0.1, 100);
    const renderer = makeRenderer();
    const gl = renderer.getContext();
    const drawn = (width: number, height: number): Uint8Array => {
      renderer.setSize(width, height, false);
      renderer.render(scene, camera);
      const pixels = new Uint8Array(4 * width * height);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return pixels;
    };
    const differing = (a: Uint8Array, b: Uint8Array): number =>
      a.reduce((sum, value, i) => sum + Number(Math.abs(value - b[i]) > 3), 0) / (0.75 * a.length);
    const from = (x: number, z: number, paperGrain: number): Uint8Array => {
      mesh.material.paperGrain = paperGrain;
      camera.position.set(x, 0, z);
      return drawn(side, side);
    };
    const grain = from(0, 2, 1);
    const moved = {
      grain: differing(grain, from(0.31, 2, 1)),
      nearer: differing(grain, from(0, 1.2, 1)),
      strokes: differing(from(0, 2, 0), from(0.31, 2, 0)),
      values: new Set(grain).size,
    };
    // The whole picture and its four quarters.
    const whole = from(0, 2, 0.5);
    let seams = 0;
    for (const [x, y] of [
      [0, 0],
      [0.5, 0],
      [0, 0.5],
      [0.5, 0.5],
    ]) {
      camera.setViewOffset(side, side, x * side, y * side, side / 2, side / 2);
      const tile = drawn(side / 2, side / 2);
      for (let row = 0; row < side / 2; row++) {
        // Rows count from below.
        const start = 4 * ((row + (0.5 - y) * side) * side + x * side);
        const line = whole.subarray(start, start + 2 * side);
        line.forEach((value, i) => {
          seams += Number(Math.abs(value - tile[2 * side * row + i]) > 8) / whole.length;
        });
      }
    }
    camera.clearViewOffset();
    return { ...moved, seams };
  });
  expect(found.values).toBeGreaterThan(50);
  expect(found.grain).toBe(0);
  expect(found.nearer).toBe(0);
  expect(found.strokes).toBeGreaterThan(0.3);
  expect(found.seams).toBeLessThan(0.002);
});

test('grain runs along the strokes, and a flat wall has no marbling', { tag: '@all' }, async ({ page }, testInfo) => {
  const found = await page.evaluate(
    async (looks) => {
      const { THREE, TonalArtMap, hatchedMesh, makeRenderer, sceneOf } = window.toolkit;
      const side = 256;
      const renderer = makeRenderer();
      renderer.setSize(side, side, false);
      const gl = renderer.getContext();
      const pixels = new Uint8Array(side * side * 4);
      const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 100);
      camera.position.set(0.3, 0.4, 3.9);
      camera.lookAt(0, 0, 0);
      const light = new THREE.AmbientLight();
      const measured: { name: string; turned: number; coherence: number; blotches: number }[] = [];
      for (const { name, degrees, style, ...look } of looks) {
        const tonalArtMap = await TonalArtMap.generate({ style });
        const parameters = { ...look, tonalArtMap, strokeAngle: (degrees * Math.PI) / 180 };
        const mesh = await hatchedMesh(new THREE.PlaneGeometry(8, 8), {
          ...parameters,
          technique: 'dryMedia',
          direction: 'sheet',
          screenSpaceShare: 1,
          latticeSpacing: 0.5,
        });
        const scene = sceneOf(mesh, light);
        for (const tone of [0.3, 0.5, 0.7]) {
          light.intensity = Math.PI * (1 - tone);
          renderer.render(scene, camera);
          gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
          const ink = (x: number, y: number) => 1 - pixels[4 * (y * side + x)] / 255;
          let [xx, xy, yy] = [0, 0, 0];
          for (let y = 1; y < side; y++) {
            for (let x = 1; x < side; x++) {
              const dx = ink(x, y) + ink(x, y - 1) - ink(x - 1, y) - ink(x - 1, y - 1);
              const dy = ink(x, y) + ink(x - 1, y) - ink(x, y - 1) - ink(x - 1, y - 1);
              [xx, xy, yy] = [xx + dx * dx, xy + dx * dy, yy + dy * dy];
            }
          }
          // Grain runs across the direction of the steepest changes.
          const along = 90 + (0.5 * Math.atan2(2 * xy, xx - yy) * 180) / Math.PI;
          const turned = Math.abs(((along - degrees + 270) % 180) - 90);
          // The tone of squares that are a few strokes wide.
          const square = 32;
          const means = Array.from({ length: (side / square) ** 2 }, (_, i) => {
            const [left, below] = [square * (i % (side / square)), square * Math.floor((i * square) / side)];
            let sum = 0;
            for (let y = 0; y < square; y++) for (let x = 0; x < square; x++) sum += ink(left + x, below + y);
            return sum / square ** 2;
          });
          const blotches = Math.sqrt(means.reduce((sum, mean) => sum + (mean - tone) ** 2, 0) / means.length);
          const coherence = Math.hypot(xx - yy, 2 * xy) / (xx + yy);
          measured.push({ name: `${name} ${tone}`, turned, coherence, blotches });
        }
      }
      return measured;
    },
    (['pencil', 'charcoal', 'chalk'] as const).flatMap((name) => {
      const { strokeWidth, paperGrain, paperGrainSize, softness, smudge, tonalArtMap: style } = PRESET_MATERIALS[name];
      const sizes = { strokeWidth, paperGrain, paperGrainSize, softness, smudge, style };
      return [25, 60].map((degrees) => ({ name: `${name} ${degrees}°`, degrees, ...sizes }));
    }),
  );
  for (const { name, turned, coherence, blotches } of found) {
    const description = `${name}: ${turned.toFixed(1)}° off, coherence ${coherence.toFixed(2)}, blotches ${blotches.toFixed(3)}`;
    testInfo.annotations.push({ type: 'grain', description });
    expect(turned, description).toBeLessThan(10);
    expect(coherence, description).toBeGreaterThan(0.13);
    expect(blotches, description).toBeLessThan(0.03);
  }
});
