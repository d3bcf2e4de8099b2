import { type PresetName, presets } from '../../src/scene/presets.js';
import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { at, isGround, SIZE } from './pixels.js';
import { techniques } from './techniques.js';
import { test } from './toolkitPage.js';

/** The depths of hollows: how far they are deepened, against numbers worked out by hand, and in presets. */

const smooth = (from: number, to: number, x: number): number => {
  const t = Math.min(Math.max((x - from) / (to - from), 0), 1);
  return t * t * (3 - 2 * t);
};

for (const technique of techniques) {
  test(
    `tone is brought to the darkest as far as occlusion and hollowStrength say: ${technique}`,
    quickIf(technique === 'adjacency' || technique === 'engraving'),
    async ({ page }) => {
      const occlusions = [0, 0.08, 0.2, 0.35, 0.5, 0.9];
      const cases = [
        { hollowStrength: 0, occlusion: 1, toneCurve: 'linear' },
        { hollowStrength: 1, occlusion: 1, toneCurve: 'linear' },
        { hollowStrength: 0.6, occlusion: 0.5, toneCurve: 'linear' },
        // A curve that leaves paper in the deepest shade, and one that draws the lights.
        {
          hollowStrength: 1,
          occlusion: 1,
          toneCurve: [
            [0, 0],
            [1, 0.7],
          ],
        },
        {
          hollowStrength: 1,
          occlusion: 1,
          toneCurve: [
            [0, 0.9],
            [1, 0.1],
          ],
        },
      ] as const;
      const seen = await page.evaluate(
        async ([technique, occlusions, cases]) => {
          const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
          const renderer = makeRenderer();
          const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2), { technique, debugView: 'tone' });
          const { hatchNormal } = mesh.geometry.attributes;
          const scene = sceneOf(mesh, sun(0.6 * Math.PI, [0, 0, 1]));
          return cases.map((look) => {
            Object.assign(mesh.material, look);
            return occlusions.map((occlusion) => {
              for (let i = 0; i < hatchNormal.count; i++) hatchNormal.setW(i, -occlusion);
              (hatchNormal as InstanceType<typeof THREE.BufferAttribute>).needsUpdate = true;
              const pixels = pixelsOf(scene, renderer);
              return pixels[4 * (48 * 96 + 48)] / 255;
            });
          });
        },
        [technique, occlusions, cases] as const,
      );
      for (const [i, { hollowStrength, occlusion, toneCurve }] of cases.entries()) {
        for (const [j, hidden] of occlusions.entries()) {
          const light = 0.6 * (1 - occlusion * hidden * smooth(0, 0.4, hidden));
          const [start, end] = toneCurve === 'linear' ? [0, 1] : [toneCurve[0][1], toneCurve[1][1]];
          const lit = start + (end - start) * (1 - light);
          const share = hollowStrength * occlusion * smooth(0.1, 0.8, hidden);
          const tone = lit + share * ((end > start ? 1 : 0) - lit);
          expect(seen[i][j], `${JSON.stringify(cases[i])} at ${hidden}`).toBeCloseTo(1 - tone, 2);
        }
      }
    },
  );
}

for (const preset of Object.keys(presets) as PresetName[]) {
  test(
    `a socket is the darkest place of a block under every light in front: ${preset}`,
    quickIf(preset === 'engraving'),
    async ({ page }) => {
      const pictures = await page.evaluate(async (look) => {
        const { THREE, UsersMaterial, bakeOcclusion, prepareHatchingGeometry } = window.toolkit;
        const { sceneOf, sun, pixelsOf, makeRenderer, greyMap } = window.toolkit;
        const renderer = makeRenderer();
        renderer.shadowMap.enabled = true;
        // A block of side 2 with a square socket in its front, as wide as deep, and a nose beside it.
        const front = new THREE.Shape(
          [
            [-1, -1],
            [1, -1],
            [1, 1],
            [-1, 1],
          ].map(([x, y]) => new THREE.Vector2(x, y)),
        );
        const rim = [
          [-0.7, -0.3],
          [-0.7, 0.3],
          [-0.1, 0.3],
          [-0.1, -0.3],
        ].map(([x, y]) => new THREE.Vector2(x, y));
        front.holes.push(new THREE.Path(rim));
        const parts = [
          new THREE.ExtrudeGeometry(front, { depth: 0.6, bevelEnabled: false }).translate(0, 0, -0.6),
          new THREE.PlaneGeometry(2, 2, 20, 20).translate(0, 0, -0.6),
          new THREE.SphereGeometry(0.25, 24, 16).translate(0.5, 0, 0.1),
        ];
        const map = greyMap();
        const meshes = await Promise.all(
          parts.map(async (part) => {
            const material = new UsersMaterial({ ...JSON.parse(look), tonalArtMap: map, debugView: 'tone' });
            const mesh = new THREE.Mesh(await prepareHatchingGeometry(part, { adjacency: true }), material);
            mesh.castShadow = mesh.receiveShadow = true;
            return mesh;
          }),
        );
        const block = new THREE.Group().add(...meshes);
        await bakeOcclusion(block);
        return [-50, -25, 0, 25, 50].flatMap((azimuth) =>
          [10, 35, 60].map((elevation) => {
            const [a, e] = [azimuth, elevation].map((degrees) => (degrees * Math.PI) / 180);
            const light = sun(Math.PI, [5 * Math.sin(a) * Math.cos(e), 5 * Math.sin(e), 5 * Math.cos(a) * Math.cos(e)]);
            light.castShadow = true;
            return pixelsOf(sceneOf(block, light), renderer);
          }),
        );
      }, JSON.stringify(presets[preset].material));
      for (const pixels of pictures) {
        const places: { dark: number; isIn: boolean }[] = [];
        for (let y = 0; y < SIZE; y++) {
          for (let x = 0; x < SIZE; x++) {
            const [red, ...others] = at(pixels, x, y);
            if (isGround([red, ...others])) continue;
            // 33 pixels to a unit at the front of the block.
            const [u, v] = [(x + 0.5 - SIZE / 2) / 33, (y + 0.5 - SIZE / 2) / 33];
            places.push({
              dark: preset === 'chalk' ? red : 255 - red,
              isIn: u > -0.74 && u < -0.06 && Math.abs(v) < 0.34,
            });
          }
        }
        expect(places.length).toBeGreaterThan(3000);
        // The bare ground of chalk and the solid ink of a woodcut are the darkest tones, shadows included.
        const isPlain = preset === 'chalk' || preset === 'woodcut';
        const equal = isPlain ? (place: { isIn: boolean }) => Number(place.isIn) : () => 0;
        places.sort((a, b) => b.dark - a.dark || equal(b) - equal(a));
        // The socket takes about a tenth of what is seen.
        const darkest = places.slice(0, Math.floor(places.length / 20));
        const share = darkest.filter(({ isIn }) => isIn).length / darkest.length;
        expect(share).toBeGreaterThan(0.9);
        // Darker than shade alone, which is 0.86 in most presets.
        expect(darkest.reduce((sum, { dark }) => sum + dark, 0) / darkest.length / 255).toBeGreaterThan(0.92);
      }
    },
  );
}
