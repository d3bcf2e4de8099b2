import type { BufferGeometry, Material } from 'three';
import type { HatchingMaterial } from 'three-hatching';
import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

/** Materials without parameters, on any geometry with normals, in any units. */

test('a material without parameters draws a pen drawing in any units, on paper that is blank until its map is there', async ({
  page,
}) => {
  const drawn = await page.evaluate(async () => {
    const { THREE, UsersMaterial, TonalArtMap, prepareHatchingGeometry, sceneOf, sun, pixelsOf, makeRenderer } =
      window.toolkit;
    const renderer = makeRenderer();
    const draw = (geometry: BufferGeometry, radius: number, material: Material) => {
      const camera = new THREE.PerspectiveCamera(40, 1, 0.1 * radius, 50 * radius);
      camera.position.set(0, 0, 3.2 * radius);
      const pixels = pixelsOf(sceneOf(new THREE.Mesh(geometry, material), sun()), renderer, camera);
      // The ground is green: what is not green in the middle is the ball.
      const ball = Array.from({ length: pixels.length / 4 }, (_, i) => i).filter(
        (i) => pixels[4 * i] === pixels[4 * i + 1] && pixels[4 * i] === pixels[4 * i + 2],
      );
      const dark = (i: number): boolean => pixels[4 * i]! < 128;
      return {
        pixels: ball.length,
        ink: ball.filter(dark).length / ball.length,
        edges: ball.filter((i) => dark(i) !== dark(i + 1)).length / ball.length,
      };
    };
    const drawings: Record<string, ReturnType<typeof draw>[]> = {};
    for (const radius of [0.01, 1, 1000]) {
      const plain = new THREE.SphereGeometry(radius, 48, 32);
      for (const geometry of [plain, await prepareHatchingGeometry(plain)]) {
        const material = new UsersMaterial();
        const isFirst = Object.keys(drawings).length === 0;
        const before = draw(geometry, radius, material);
        const { version } = material;
        await material.ready;
        const after = draw(geometry, radius, material);
        if (material.version !== version) throw new Error('the map brought another program');
        if (material.uniforms.tonalArtMap.value !== TonalArtMap.shared().texture) throw new Error('not the shared map');
        drawings[`${radius} ${geometry === plain ? 'plain' : 'prepared'}`] = isFirst ? [before, after] : [after];
      }
    }
    return drawings;
  });
  const [[before]] = Object.values(drawn);
  expect(before!.pixels).toBeGreaterThan(3000);
  expect(before!.ink).toBe(0);
  const inks = Object.values(drawn).map((drawings) => drawings.at(-1)!.ink);
  for (const [name, drawings] of Object.entries(drawn)) {
    const { ink, edges } = drawings.at(-1)!;
    // A third of the ball in ink, in strokes and not in one piece.
    expect(ink, name).toBeGreaterThan(0.15);
    expect(ink, name).toBeLessThan(0.5);
    expect(edges, name).toBeGreaterThan(0.1);
  }
  expect(Math.max(...inks) - Math.min(...inks)).toBeLessThan(0.03);
});

test('a preset by its name draws the same as its parameters, and one map of a style serves all materials', async ({
  page,
}) => {
  const outcome = await page.evaluate(async () => {
    const { THREE, UsersMaterial, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const scene = (material: Material) =>
      sceneOf(new THREE.Mesh(new THREE.TorusKnotGeometry(0.6, 0.25, 96, 16), material), sun());
    const draw = async (material: HatchingMaterial) => {
      pixelsOf(scene(material), renderer);
      await material.ready;
      return pixelsOf(scene(material), renderer);
    };
    const hand = {
      technique: 'pen',
      direction: 'auto',
      strokeLength: 72,
      lineSpacing: 4.4,
    } as const;
    const values = { composition: { exposure: 'fit' }, colorHatching: 0.8, colorFill: 0, hollowStrength: 1 } as const;
    const pen = await draw(new UsersMaterial({ preset: 'pen' }));
    const { textures } = renderer.info.memory;
    const black = await draw(
      new UsersMaterial({
        ...{ ...hand, ...values, crossFrom: 0.6, irregularity: 0.6, toneCurve: 'printed', reflectedLight: 0.35 },
        ...{ ink: '#1c1a17', paper: '#f7f3e8' },
      }),
    );
    const engraved = await draw(new UsersMaterial({ preset: 'engraving', ink: 'black', paper: 'white' }));
    const bare = await draw(new UsersMaterial({ technique: 'engraving', direction: 'auto', ...values }));
    const same = (a: number[], b: number[]): boolean => a.every((value, i) => value === b[i]);
    return { pen: same(pen, black), engraved: same(engraved, bare), more: renderer.info.memory.textures - textures };
  });
  expect(outcome).toEqual({ pen: true, engraved: true, more: 0 });
});
