import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

test('strokes turn counterclockwise, as seen from outside, in every technique', async ({ page }) => {
  const turned = await page.evaluate(async () => {
    const { THREE, hatchedMesh, makeCamera, makeRenderer, pixelsOf, sceneOf, SIZE, TonalArtMap } = window.toolkit;
    // Soft stripes: of hard ones, edges would have few directions.
    const [blank, stripes] = [() => 255, (i: number) => Math.round(127.5 * (1 + Math.cos((i * Math.PI) / 8)))].map(
      (value) => Uint8Array.from({ length: 64 * 64 }, (_, i) => value(i)),
    );
    const tonalArtMap = TonalArtMap.fromHatchImages({ size: 64, images: [[blank], [stripes], [stripes]] });
    const light = new THREE.DirectionalLight(0xffffff, 0.5 * Math.PI);
    light.position.set(0, 1, 2);
    const renderer = makeRenderer();
    const camera = makeCamera();
    const found: Record<string, number> = {};
    for (const technique of ['triangle', 'adjacency', 'hatching', 'engraving'] as const) {
      const mesh = await hatchedMesh(new THREE.PlaneGeometry(20, 20), {
        technique,
        ...(technique === 'engraving'
          ? { screenSpaceShare: 1, lineSpacing: 10, irregularity: 0, crossFrom: 1, tonalArtMap: null }
          : { tilesPerObjectUnit: 1, tonalArtMap }),
      });
      // The direction that the picture changes in, from −π/2 to π/2: twice the angle of the mean of squared gradients.
      const across = (strokeAngle: number): number => {
        mesh.material.strokeAngle = strokeAngle;
        const pixels = pixelsOf(sceneOf(mesh, light), renderer, camera);
        let [x2, xy, y2] = [0, 0, 0];
        for (let y = 0; y < SIZE - 1; y++) {
          for (let x = 0; x < SIZE - 1; x++) {
            const i = 4 * (y * SIZE + x);
            const gx = pixels[i + 4] - pixels[i];
            const gy = pixels[i + 4 * SIZE] - pixels[i];
            x2 += gx * gx;
            xy += gx * gy;
            y2 += gy * gy;
          }
        }
        return Math.atan2(2 * xy, x2 - y2) / 2;
      };
      const turn = across(0.4) - across(0);
      found[technique] = turn - Math.PI * Math.round(turn / Math.PI);
    }
    return found;
  });
  // Crisp edges are steps, and lines turn from one of some directions to the next: the sense counts, not the angle.
  for (const [technique, turn] of Object.entries(turned)) {
    expect(turn, technique).toBeGreaterThan(0.25);
    expect(turn, technique).toBeLessThan(0.8);
  }
});
