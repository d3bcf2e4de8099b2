import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { at, difference, SIZE } from './pixels.js';
import { test } from './toolkitPage.js';

/** Maps and emitted light that count for tone, against three's own Lambert material with the same ones. */

const luminance = ([r, g, b]: number[]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** Largest difference of a tone from the luminance of a colour, away from the silhouette. */
function worst(tone: number[], lambert: number[]): number {
  let most = 0;
  for (let y = 1; y < SIZE - 1; y++) {
    for (let x = 1; x < SIZE - 1; x++) {
      const near = [at(lambert, x - 1, y), at(lambert, x + 1, y), at(lambert, x, y - 1), at(lambert, x, y + 1)];
      if (near.some(([r, g]) => r === 0 && g === 255)) continue;
      most = Math.max(most, Math.abs(at(tone, x, y)[0] - luminance(at(lambert, x, y))));
    }
  }
  return most;
}

// One technique that shades triangles and one that shades fragments; besideLambert.spec.ts draws each map with every technique.
for (const technique of ['triangle', 'engraving'] as const) {
  test(
    `maps, emitted light and flat shading make the tone of three's Lambert, set late too: ${technique}`,
    quickIf(technique === 'triangle'),
    async ({ page }) => {
      const shown = await page.evaluate(async (technique) => {
        const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
        const renderer = makeRenderer();
        const geometry = new THREE.SphereGeometry(1, 24, 16);
        const { uv } = geometry.attributes;
        for (const [name, shift] of [
          ['uv1', 1],
          ['uv2', 0.7],
          ['uv3', 0.4],
        ] as const) {
          const shifted = uv.array.map((x: number) => shift - x);
          geometry.setAttribute(name, new THREE.BufferAttribute(shifted, 2));
        }
        const texture = (color: (x: number, y: number) => number[], channel = 0) => {
          const texels = Uint8Array.from({ length: 32 * 32 * 4 }, (_, i) => color((i >> 2) % 32, i >> 7)[i % 4] ?? 255);
          const made = new THREE.DataTexture(texels, 32, 32);
          made.magFilter = made.minFilter = THREE.LinearFilter;
          made.wrapS = made.wrapT = THREE.RepeatWrapping;
          made.repeat.set(2, 1);
          made.offset.set(0.1 * channel, 0.2);
          made.rotation = 0.3 + channel;
          made.channel = channel;
          made.needsUpdate = true;
          return made;
        };
        const wave = (x: number) => 128 + 80 * Math.sin((x / 16) * Math.PI);
        const normalMap = texture((x, y) => [wave(x), wave(y + 5), 230]);
        const grey = (channel: number) => texture((x, y) => [wave(x), wave(y), wave(x + y)], channel);
        const given: Record<string, object> = {
          nothing: {},
          'a normal map': { normalMap, normalScale: new THREE.Vector2(0.7, -0.5) },
          'a normal map of object space': { normalMap, normalMapType: THREE.ObjectSpaceNormalMap },
          'a bump map': { bumpMap: grey(0), bumpScale: 0.5 },
          'ambient occlusion': { aoMap: grey(1), aoMapIntensity: 0.8 },
          'a light map': { lightMap: grey(1), lightMapIntensity: 0.6 },
          'both, and emitted light': {
            aoMap: grey(0),
            lightMap: grey(1),
            emissive: new THREE.Color(0.1, 0.2, 0.05),
            emissiveIntensity: 1.5,
          },
          'a map of emitted light': { emissive: new THREE.Color(0.5, 0.4, 0.3), emissiveMap: grey(0) },
          'maps of four channels': {
            lightMap: grey(0),
            lightMapIntensity: 0.5,
            aoMap: grey(1),
            bumpMap: grey(2),
            emissive: new THREE.Color(0.3, 0.3, 0.2),
            emissiveMap: grey(3),
          },
          'flat shading': { flatShading: true },
        };
        const scene = sceneOf(new THREE.AmbientLight(0xffffff, 0.9), sun(1.2));
        const show = (mesh: InstanceType<typeof THREE.Mesh>) => {
          scene.add(mesh);
          const pixels = pixelsOf(scene, renderer);
          scene.remove(mesh);
          return pixels;
        };
        const pairs: [string, number[], number[]][] = [];
        for (const [name, parameters] of Object.entries(given)) {
          const hatched = await hatchedMesh(geometry, {
            technique,
            toneNormal: 'smooth',
            debugView: 'tone',
          });
          show(hatched);
          hatched.material.setValues(parameters);
          const lambert = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial(parameters));
          pairs.push([name, show(hatched), show(lambert)]);
        }
        return pairs;
      }, technique);
      const [[, , plain]] = shown;
      for (const [name, tone, lambert] of shown) {
        if (name !== 'nothing') expect(difference(plain, lambert), name).toBeGreaterThan(10);
        expect(worst(tone, lambert), name).toBeLessThanOrEqual(4);
      }
    },
  );
}

test('face normals stay those of the triangles under a normal map', async ({ page }) => {
  const [plain, mapped] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
    const normalMap = new THREE.DataTexture(new Uint8Array([250, 128, 150, 255]), 1, 1);
    normalMap.needsUpdate = true;
    const geometry = new THREE.SphereGeometry(1, 24, 16);
    geometry.computeTangents();
    return [
      pixelsOf(sceneOf(await hatchedMesh(geometry), sun())),
      pixelsOf(sceneOf(await hatchedMesh(geometry, { normalMap }), sun())),
    ];
  });
  expect(difference(plain, mapped)).toBe(0);
});
