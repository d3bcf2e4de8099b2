import type { HatchingTechnique } from '../../src/look/hatchingProperties.js';
import { mirroredRoom, shareOfRoom } from '../../src/vector/shading/metal.js';
import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

/** Degrees around x by which a wall leans back, and degrees of the eye above it: its light, its horizon, its dark and its floor. */
const PLACES = [
  [0, 0],
  [30, 0],
  [-4, 8],
  [-5, 8],
  [-15, 0],
  [-40, 10],
  [40, -20],
] as const;

const radians = (degrees: number): number => (degrees * Math.PI) / 180;

for (const [technique, isOrthographic] of [
  ['engraving', false],
  ['hatching', true],
  ['dryMedia', false],
  ['stipple', false],
  ['woodcut', true],
  ['triangle', false],
  ['adjacency', true],
] as const satisfies readonly [HatchingTechnique, boolean][]) {
  test(
    `metal mirrors a room as the reference on the processor: ${technique}`,
    quickIf(technique === 'engraving'),
    async ({ page }) => {
      const metals = [
        { metalness: 1, roughness: 0 },
        { metalness: 0.6, roughness: 0.5 },
        { metalness: 1, roughness: 0.8 },
      ];
      const printed = await page.evaluate(
        async ([technique, isOrthographic, places, metals]) => {
          const { THREE, hatchedMesh, makeRenderer, sceneOf } = window.toolkit;
          const mesh = await hatchedMesh(new THREE.PlaneGeometry(4, 4), {
            ...{ technique, debugView: 'tone', toneCurve: 'linear', composition: { exposure: 1 } },
            ...{ reflectedLight: 0, side: THREE.DoubleSide },
          });
          const scene = sceneOf(mesh, new THREE.AmbientLight(0xffffff, 0.5 * Math.PI));
          const camera = isOrthographic
            ? new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 10)
            : new THREE.PerspectiveCamera(10, 1, 0.1, 10);
          const renderer = makeRenderer();
          const gl = renderer.getContext();
          const pixel = new Uint8Array(4);
          const tones: number[] = [];
          for (const metal of metals) {
            Object.assign(mesh.material, metal);
            await mesh.material.ready;
            for (const [lean, elevation] of places) {
              mesh.rotation.x = (-lean * Math.PI) / 180;
              const angle = (elevation * Math.PI) / 180;
              camera.position.set(0, 3 * Math.sin(angle), 3 * Math.cos(angle));
              camera.lookAt(0, 0, 0);
              renderer.render(scene, camera);
              gl.readPixels(48, 48, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
              tones.push(1 - pixel[0] / 255);
            }
          }
          return tones;
        },
        [technique, isOrthographic, PLACES, metals] as const,
      );
      const expected = metals.flatMap((metal) =>
        PLACES.map(([lean, elevation]) => {
          const [n, v] = [radians(lean), radians(elevation)];
          const room = mirroredRoom([0, Math.sin(n), Math.cos(n)], [0, Math.sin(v), Math.cos(v)]);
          return 0.5 + shareOfRoom(metal) * (1 - room - 0.5);
        }),
      );
      expect(printed).toHaveLength(expected.length);
      // Half a pixel beside the middle the eye sees a wall at another angle.
      for (const [i, tone] of expected.entries())
        expect(Math.abs(printed[i] - tone), `${i}: ${printed}`).toBeLessThan(0.02);
      // The two tones and a floor between them.
      expect(Math.min(...printed)).toBeLessThan(0.1);
      expect(Math.max(...printed)).toBeGreaterThan(0.8);
    },
  );
}
