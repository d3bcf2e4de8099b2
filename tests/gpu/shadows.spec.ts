import { quickIf } from '../browser/quickIf.js';
import { expect, testOnOnePage as onOnePage } from '../browser/test.js';
import type { Filter, LightKind } from './shadows.js';
import { techniques } from './techniques.js';

/** Shadows under every kind of light: where they end, how dark they are, and what strokes do in them. */

const test = onOnePage('tests/gpu/shadows.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.shading !== undefined);
});

const shadowStrokes = ['tone', 'cross', 'reorient'] as const;

const outlines: [Filter, LightKind][] = [
  ...(['directional', 'spot', 'point', 'point over a seam', 'sun'] as const).flatMap((kind) =>
    (['PCF', 'Basic'] as const).map((filter): [Filter, LightKind] => [filter, kind]),
  ),
  ['VSM', 'directional'],
  ['VSM', 'spot'],
  ['VSM', 'sun'],
];

for (const [filter, kind] of outlines) {
  test(
    `the outline of a ball's shadow is the ellipse, to 1.5 texels, without stairs: ${filter}, ${kind}`,
    quickIf(
      ['PCF, directional', 'PCF, point over a seam', 'Basic, spot', 'VSM, directional', 'PCF, sun'].includes(
        `${filter}, ${kind}`,
      ),
    ),
    async ({ page }) => {
      const { wrong, inside, steepest, pixelsPerTexel } = await page.evaluate(
        async ([filter, kind]) => {
          const { SIZE, lightOf, casting, clearances, ball, ground, rendererOf, sceneOf, draw } = window.shading;
          const light = casting(await lightOf(kind));
          const plane = await ground('triangle', {}, true);
          const scene = sceneOf(plane, ball(), light);
          const shadowed = draw(scene, rendererOf(filter));
          const away = clearances(kind, light);
          plane.receiveShadow = false;
          const lit = draw(scene, rendererOf(filter));
          const share = away.map((_, i) => shadowed[4 * i] / lit[4 * i]);
          const wrong = away.filter((d, i) => (d < -1.5 ? share[i] > 0.01 : d > 1.5 && share[i] < 0.99)).length;
          let steepest = 0;
          let texels = 0;
          for (let i = 0; i < away.length; i++) {
            if (i % SIZE === 0 || i < SIZE || Math.abs(away[i]) > 3) continue;
            steepest = Math.max(steepest, Math.abs(share[i] - share[i - 1]), Math.abs(share[i] - share[i - SIZE]));
            texels = Math.max(texels, Math.abs(away[i] - away[i - 1]), Math.abs(away[i] - away[i - SIZE]));
          }
          return { wrong, inside: away.filter((d) => d < 0).length, steepest, pixelsPerTexel: 1 / texels };
        },
        [filter, kind] as const,
      );
      expect(inside).toBeGreaterThan(2200);
      expect(wrong).toBe(0);
      // From lit to shadowed the mean of four texels goes over a texel, more steeply only where its cells meet.
      if (filter !== 'VSM') expect(steepest).toBeLessThan(Math.min(1.5 / pixelsPerTexel, 0.95));
    },
  );
}

for (const kind of ['directional', 'spot', 'point', 'sun'] as const) {
  test(
    `soft edges are as wide as asked, rise evenly, and belong to the ground, not to the screen: ${kind}`,
    quickIf(kind === 'point'),
    async ({ page }) => {
      const { moved, widths, falls } = await page.evaluate(async (kind) => {
        const { SIZE, lightOf, casting, clearances, ball, ground, rendererOf, sceneOf, draw, above } = window.shading;
        const light = casting(await lightOf(kind), 3);
        const plane = await ground('triangle', {}, true);
        const scene = sceneOf(plane, ball(), light);
        const renderer = rendererOf();
        const [right, up] = [17, -6];
        const straight = draw(scene, renderer);
        const aside = draw(scene, renderer, above(right, up));
        let moved = 0;
        for (let y = 6; y < SIZE; y++) {
          for (let x = 17; x < SIZE; x++) {
            const there = (y - up) * SIZE + x - right;
            if (y - up >= SIZE) continue;
            // The cascades of a sun follow the camera, and its texels with them.
            moved = Math.max(moved, Math.abs(straight[4 * (y * SIZE + x)] - aside[4 * there]));
          }
        }
        const widths = [1, 3].map((radius) => {
          light.shadow.radius = radius;
          const soft = draw(scene, renderer);
          plane.receiveShadow = false;
          const lit = draw(scene, renderer);
          plane.receiveShadow = true;
          const away = clearances(kind, light);
          return away.filter((_, i) => soft[4 * i] > 0.05 * lit[4 * i] && soft[4 * i] < 0.95 * lit[4 * i]).length;
        });
        // Along a row from the middle of the shadow outwards it only grows lighter.
        light.shadow.radius = 3;
        const soft = draw(scene, renderer);
        const away = clearances(kind, light);
        const middle = away.indexOf(Math.min(...away));
        let falls = 0;
        for (let i = middle + 1; i % SIZE !== 0 && away[i] < 8; i++)
          falls = Math.max(falls, soft[4 * i - 4] - soft[4 * i]);
        return { moved, widths, falls };
      }, kind);
      if (kind !== 'sun') expect(moved).toBeLessThanOrEqual(1);
      expect(widths[1] / widths[0]).toBeGreaterThan(1.5);
      expect(falls).toBeLessThanOrEqual(2);
    },
  );
}

for (const radius of [0, 1, 3]) {
  test(
    `while the camera turns, the edge of a shadow flips no more pixels than that of a disc: radius ${radius}`,
    quickIf(radius === 1),
    async ({ page }) => {
      const { shadow, disc } = await page.evaluate(async (radius) => {
        const { THREE, lightOf, casting, ball, ground, sceneOf, draw, ellipse } = window.shading;
        const light = casting(await lightOf('directional'), radius);
        const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 20);
        /** Pixels that change sides, summed over steps of a twentieth of a degree. */
        const flips = (scene: InstanceType<typeof THREE.Scene>) => {
          let count = 0;
          let before: boolean[] = [];
          for (let step = 0; step <= 20; step++) {
            const angle = ((30 + step / 20) * Math.PI) / 180;
            camera.up.set(0, 0, 1);
            camera.position.set(3 * Math.cos(angle), 3 * Math.sin(angle), 2.5);
            camera.lookAt(0, 0, 0);
            const pixels = draw(scene, undefined, camera);
            const isDark = Array.from({ length: pixels.length / 4 }, (_, i) => pixels[4 * i] < 90);
            if (step > 0) count += isDark.filter((value, i) => value !== before[i]).length;
            before = isDark;
          }
          return count;
        };
        const plane = await ground('triangle', { color: '#ffffff' }, true);
        return {
          shadow: flips(sceneOf(plane, ball(), light)),
          disc: flips(sceneOf(await ground('triangle', {}, true), ellipse(light), await lightOf('directional'))),
        };
      }, radius);
      expect(disc).toBeGreaterThan(200);
      expect(shadow / disc).toBeLessThan(1.03);
    },
  );
}

for (const technique of techniques) {
  test(
    `outside a shadow no stroke changes, and inside the tone is that of the other lights: ${technique}`,
    quickIf(technique === 'engraving'),
    async ({ page }) => {
      const results = await page.evaluate(
        async ([technique, shadowStrokes]) => {
          const { lightOf, casting, clearances, ball, ground, sceneOf, draw, compared } = window.shading;
          const light = casting(await lightOf('directional', 1.8));
          const rest = await lightOf('point', 1.1);
          const plane = await ground(technique);
          const grey = await ground('triangle', {}, true);
          const away = clearances('directional', light);
          const scene = sceneOf(plane, ball(), light, rest);
          const greyScene = sceneOf(grey, ball(), light.clone(), rest.clone());
          return shadowStrokes.map((choice) => {
            plane.material.shadowStrokes = choice;
            grey.material.shadowStrokes = choice;
            plane.receiveShadow = true;
            const shadowed = draw(scene);
            const shadowedGrey = draw(greyScene);
            plane.receiveShadow = false;
            const lit = draw(scene);
            light.intensity = 0;
            greyScene.children[2].visible = false;
            const without = draw(scene);
            const withoutGrey = draw(greyScene);
            light.intensity = 1.8;
            greyScene.children[2].visible = true;
            return {
              choice,
              outside: compared(shadowed, lit, (i) => away[i] > 2.5),
              inside: compared(shadowed, without, (i) => away[i] < -2.5),
              grey: compared(shadowedGrey, withoutGrey, (i) => away[i] < -2.5),
            };
          });
        },
        [technique, shadowStrokes] as const,
      );
      for (const { choice, outside, inside, grey } of results) {
        expect(outside.count).toBeGreaterThan(8000);
        expect(outside.most, choice).toBe(0);
        expect(grey.count).toBeGreaterThan(1500);
        expect(grey.most, choice).toBeLessThanOrEqual(2);
        // The mean of a few strokes is arbitrary.
        expect(Math.abs(inside.means[0] - inside.means[1]), choice).toBeLessThan(0.04);
      }
    },
  );
}

for (const technique of ['hatching', 'engraving'] as const) {
  for (const blocked of ['directional', 'spot', 'point', 'sun'] as const) {
    test(
      `strokes turn to the lights that arrive: ${technique}, a shadow of ${blocked} among others`,
      quickIf(blocked === (technique === 'hatching' ? 'spot' : 'point')),
      async ({ page }) => {
        const results = await page.evaluate(
          async ([technique, blocked]) => {
            const { hasSun, lightOf, casting, clearances, ball, ground, sceneOf, draw, compared } = window.shading;
            const places = {
              directional: [2, 0, 1.5],
              spot: [0, 2.4, 2],
              point: [-1.8, -0.5, 2],
              sun: [-1, -2, 2],
            } as const;
            const lights = await Promise.all(
              [...(['directional', 'spot', 'point'] as const), ...(hasSun ? (['sun'] as const) : [])].map(
                async (kind) => {
                  // Brightest of all, so that where it does not arrive the others have another mean.
                  const light = await lightOf(kind, kind === blocked ? 2 : 0.35);
                  if (kind === blocked) casting(light);
                  else light.position.fromArray(places[kind]);
                  return light;
                },
              ),
            );
            const plane = await ground(technique, { shadowStrokes: 'reorient' });
            const scene = sceneOf(plane, ball(), ...lights);
            const light = lights.find(({ castShadow }) => castShadow)!;
            const shadowed = draw(scene);
            const away = clearances(blocked, light);
            const isInside = (i: number) => away[i] < -2.5;
            plane.material.shadowStrokes = 'tone';
            const darkened = draw(scene);
            light.intensity = 0;
            const without = draw(scene);
            return {
              turned: compared(shadowed, without, isInside),
              darkened: compared(darkened, without, isInside),
            };
          },
          [technique, blocked] as const,
        );
        expect(results.turned.share).toBeLessThan(0.02);
        // Strokes that had not turned would lie elsewhere.
        expect(results.darkened.share).toBeGreaterThan(0.15);
      },
    );
  }
}

for (const technique of techniques) {
  test(
    `under one light strokes run across it in its shadow, and as before outside: ${technique}`,
    quickIf(technique === 'adjacency' || technique === 'hatching'),
    async ({ page }) => {
      const { inside, outside, straight } = await page.evaluate(async (technique) => {
        const { THREE, lightOf, casting, clearances, ball, ground, sceneOf, draw, compared } = window.shading;
        const light = casting(await lightOf('directional', 1.5));
        const plane = await ground(technique, { shadowStrokes: 'reorient' });
        // The tone where the light does not arrive.
        const ambient = new THREE.AmbientLight(0xffffff, 1.6);
        const scene = sceneOf(plane, ball(), ambient, light);
        const away = clearances('directional', light);
        const shadowed = draw(scene);
        plane.receiveShadow = false;
        const lit = draw(scene);
        light.castShadow = false;
        light.intensity = 0;
        const straight = draw(scene);
        if (technique === 'hatching' || technique === 'engraving') {
          light.position.cross(new THREE.Vector3(0, 1, 0));
        } else plane.material.strokeAngle = Math.PI / 2;
        const across = draw(scene);
        const isInside = (i: number) => away[i] < -2.5;
        return {
          inside: compared(shadowed, across, isInside),
          straight: compared(shadowed, straight, isInside),
          outside: compared(shadowed, lit, (i) => away[i] > 2.5),
        };
      }, technique);
      expect(outside.most).toBe(0);
      expect(inside.share).toBeLessThan(0.005);
      expect(straight.share).toBeGreaterThan(0.1);
    },
  );
}

test('a brighter light outweighs another where frames are made before shadows are known', async ({ page }) => {
  const shares = await page.evaluate(async () => {
    const { lightOf, casting, clearances, ball, ground, sceneOf, draw, compared } = window.shading;
    const light = casting(await lightOf('directional', 1));
    const other = await lightOf('point', 1);
    const plane = await ground('triangle', { shadowStrokes: 'reorient' });
    const scene = sceneOf(plane, ball(), light, other);
    const away = clearances('directional', light);
    return [
      [1.5, 0.5],
      [0.5, 1.5],
    ].map(([shadowed, free]) => {
      [light.intensity, other.intensity] = [shadowed, free];
      plane.material.shadowStrokes = 'reorient';
      const turned = draw(scene);
      plane.material.shadowStrokes = 'tone';
      return compared(turned, draw(scene), (i) => away[i] < -2.5).share;
    });
  });
  expect(shares[0]).toBeGreaterThan(0.1);
  expect(shares[1]).toBe(0);
});

for (const technique of techniques) {
  test(
    `the tone of shadows alone: nothing elsewhere, and inside the share that is taken: ${technique}`,
    quickIf(technique === 'engraving'),
    async ({ page }) => {
      const { elsewhere, means, inside } = await page.evaluate(
        async ([technique, shadowStrokes]) => {
          const { THREE, SIZE, lightOf, casting, clearances, ball, shadowGround, rendererOf, sceneOf, draw } =
            window.shading;
          const light = casting(await lightOf('directional', 2));
          const plane = await shadowGround(technique, { paperOpacity: 0, transparent: true, ink: '#204060' });
          const scene = sceneOf(plane, ball(), light, new THREE.AmbientLight(0xffffff, 1));
          const renderer = rendererOf('PCF', { alpha: true });
          renderer.setClearAlpha(0);
          const away = clearances('directional', light);
          let elsewhere = 0;
          const means = shadowStrokes.map((choice) => {
            plane.material.shadowStrokes = choice;
            const pixels = draw(scene, renderer);
            const alphas = away.map((_, i) => pixels[4 * i + 3] / 255);
            for (let i = 0; i < SIZE * SIZE; i++) {
              if (away[i] > 2.5) for (let c = 0; c < 4; c++) elsewhere = Math.max(elsewhere, pixels[4 * i + c]);
            }
            const within = alphas.filter((_, i) => away[i] < -2.5);
            return within.reduce((sum, alpha) => sum + alpha, 0) / within.length;
          });
          const arriving = (2 * light.position.z) / light.position.length();
          return { elsewhere, means, inside: arriving / (arriving + 1) };
        },
        [technique, shadowStrokes] as const,
      );
      expect(elsewhere).toBe(0);
      for (const mean of means) expect(Math.abs(mean - inside)).toBeLessThan(0.06);
    },
  );
}

test('without a shadow the tone of shadows alone is nothing at all', async ({ page }) => {
  const ink = await page.evaluate(async () => {
    const { THREE, lightOf, shadowGround, sceneOf, draw } = window.shading;
    const inkUnder = async (...lights: InstanceType<typeof THREE.Light>[]) => {
      // A curve that prints blank paper, as of chalk.
      const toneCurve = [
        [0, 0.5],
        [1, 0],
      ] as const;
      const pixels = draw(sceneOf(await shadowGround('hatching', { toneCurve }), ...lights));
      return pixels.reduce((least, value) => Math.min(least, value), 255);
    };
    return [
      await inkUnder(),
      await inkUnder(await lightOf('spot')),
      await inkUnder(new THREE.AmbientLight(0xffffff, 0.1)),
    ];
  });
  expect(ink).toEqual([255, 255, 255]);
});

for (const technique of techniques) {
  test(
    `instances, skins${technique === 'hatching' ? ' and every depth buffer' : ''} carry shadows that strokes know of: ${technique}`,
    quickIf(technique === 'triangle'),
    async ({ page }) => {
      const shares = await page.evaluate(async (technique) => {
        const { THREE, lightOf, casting, ball, ground, rendererOf, sceneOf, draw, compared, prepareHatchingGeometry } =
          window.shading;
        // A shadow map belongs to the renderer that drew it.
        const show = async (mesh: InstanceType<typeof THREE.Mesh>, parameters = {}) => {
          mesh.receiveShadow = true;
          const lights = [
            casting(await lightOf('directional', 1.8)),
            casting(await lightOf('point', 0.6)),
            await lightOf('spot', 0.6),
          ];
          return draw(sceneOf(mesh, ball(), ...lights), rendererOf('PCF', parameters));
        };
        const plain = await ground(technique, { shadowStrokes: 'reorient' });
        const { geometry, material } = plain;
        const instances = new THREE.InstancedMesh(geometry, material, 1);
        instances.setMatrixAt(0, new THREE.Matrix4());
        const source = new THREE.PlaneGeometry(2.4, 2.4, 5, 5);
        const { count } = source.getAttribute('position');
        const weights = Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0));
        source.setAttribute('skinIndex', new THREE.BufferAttribute(new Uint16Array(4 * count), 4));
        source.setAttribute('skinWeight', new THREE.BufferAttribute(weights, 4));
        const skin = new THREE.SkinnedMesh(await prepareHatchingGeometry(source, { adjacency: true }), material);
        const bone = new THREE.Bone();
        skin.add(bone);
        skin.bind(new THREE.Skeleton([bone]));
        const turned = await show(plain);
        const pictures = [await show(instances), await show(skin)].map((pixels) => [pixels, turned]);
        if (technique === 'hatching') {
          // The effect of the depth buffer on shadows does not depend on the technique.
          material.shadowStrokes = 'cross';
          const crossed = await show(plain);
          pictures.push([await show(plain, { logarithmicDepthBuffer: true }), crossed]);
          pictures.push([await show(plain, { reversedDepthBuffer: true } as object), crossed]);
        }
        return pictures.map(([pixels, expected]) => compared(pixels, expected, () => true).share);
      }, technique);
      for (const share of shares) expect(share).toBeLessThan(0.005);
    },
  );
}

test('a smooth body of few triangles casts no shadow onto its own lit side', { tag: '@all' }, async ({ page }) => {
  const shares = await page.evaluate(
    async ([techniques, shadowStrokes]) => {
      const { THREE, lightOf, casting, ground, sceneOf, draw, compared, prepareHatchingGeometry } = window.shading;
      const geometry = await prepareHatchingGeometry(new THREE.SphereGeometry(0.8, 16, 12), { adjacency: true });
      const light = casting(await lightOf('directional', 3));
      light.position.set(1.5, 1, 0.8);
      light.shadow.bias = 0;
      const rest = await lightOf('point', 1.2);
      rest.position.set(-2, 1, 2);
      const shares: number[] = [];
      for (const technique of techniques) {
        const { material } = await ground(technique, { toneNormal: 'smooth' });
        const mesh = new THREE.Mesh(geometry, material);
        mesh.castShadow = true;
        const scene = sceneOf(mesh, light, rest);
        for (const choice of shadowStrokes) {
          material.shadowStrokes = choice;
          mesh.receiveShadow = true;
          const shadowed = draw(scene);
          mesh.receiveShadow = false;
          shares.push(compared(shadowed, draw(scene), () => true).share);
        }
      }
      return shares;
    },
    [techniques, shadowStrokes] as const,
  );
  expect(shares).toHaveLength(12);
  for (const share of shares) expect(share).toBeLessThan(0.002);
});
