import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { centre, covered, difference, differing } from './pixels.js';
import { kindsOfTechnique } from './techniques.js';
import { test } from './toolkitPage.js';

/** Lights that come and go while the page runs, and layers of strokes: where several disagree, and in the darks. */

for (const technique of kindsOfTechnique) {
  test(
    `a number of lights seen before needs no new program, and no light that only changes does: ${technique}`,
    quickIf(technique !== 'hatching'),
    async ({ page }) => {
      const compiled = await page.evaluate(async (technique) => {
        const { THREE, hatchedMesh, stripedMap, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
        const renderer = makeRenderer();
        const mesh = await hatchedMesh(new THREE.SphereGeometry(1, 16, 12), {
          tonalArtMap: stripedMap(),
          technique,
          ...(technique !== 'engraving' && { strokeLayers: 'lights' as const }),
          reflectedLight: 0.3,
        });
        const second = new THREE.SpotLight(0xffffff, 3, 0, 0.5, 0.5, 0);
        second.position.set(-2, 1, 2);
        const scene = sceneOf(mesh, sun(), second);
        const gl = renderer.getContext();
        const link = gl.linkProgram.bind(gl);
        let linked = 0;
        gl.linkProgram = (program) => {
          linked++;
          link(program);
        };
        const steps: Record<string, () => void> = {
          start: () => {},
          moved: () => second.position.set(2, -1, 2),
          'turned down to nothing': () => {
            second.intensity = 0;
          },
          'other cone, colour and distance': () => {
            Object.assign(second, { intensity: 2, angle: 0.7, penumbra: 0.1, distance: 9, decay: 1 });
            second.color.set('orange');
          },
          'switched off': () => {
            second.visible = false;
          },
          'switched on again': () => {
            second.visible = true;
          },
          'off once more': () => {
            second.visible = false;
          },
          removed: () => scene.remove(second),
          'back again': () => {
            second.visible = true;
            scene.add(second);
          },
        };
        return Object.entries(steps).map(([name, step]) => {
          const before = linked;
          step();
          pixelsOf(scene, renderer);
          return [name, linked - before] as const;
        });
      }, technique);
      expect(Object.fromEntries(compiled)).toEqual({
        start: 1,
        moved: 0,
        'turned down to nothing': 0,
        'other cone, colour and distance': 0,
        'switched off': 1,
        'switched on again': 0,
        'off once more': 0,
        removed: 0,
        'back again': 0,
      });
    },
  );
}

test('compileAsync prepares a number of lights before they are switched on', async ({ page, pageProblems }) => {
  const linked = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer, makeCamera } = window.toolkit;
    const renderer = makeRenderer();
    const second = sun(1, [-1, 0, 1]);
    const scene = sceneOf(await hatchedMesh(new THREE.SphereGeometry(1, 16, 12)), sun(), second);
    await renderer.compileAsync(scene, makeCamera());
    second.visible = false;
    pixelsOf(scene, renderer);
    const gl = renderer.getContext();
    let linked = 0;
    const link = gl.linkProgram.bind(gl);
    gl.linkProgram = (program) => {
      linked++;
      link(program);
    };
    second.visible = true;
    pixelsOf(scene, renderer);
    return linked;
  });
  expect(linked).toBe(0);
  // A software rasterizer compiles while one waits.
  expect(pageProblems.splice(0).filter((problem) => !problem.includes('KHR_parallel_shader_compile'))).toEqual([]);
});

test('a light probe lights from all around; a rectangular light gives no light, and no error', async ({ page }) => {
  const [dark, rectangular, probe] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, pixelsOf } = window.toolkit;
    const wall = await hatchedMesh(new THREE.PlaneGeometry(2, 2));
    const rectangle = new THREE.RectAreaLight(0xffffff, 10, 2, 2);
    rectangle.position.z = 2;
    const sh = new THREE.SphericalHarmonics3();
    // Irradiance is 0.886227 times the first coefficient.
    sh.coefficients[0].setScalar(Math.PI / 2 / 0.886227);
    return [
      pixelsOf(sceneOf(wall)),
      pixelsOf(sceneOf(wall, rectangle)),
      pixelsOf(sceneOf(wall, new THREE.LightProbe(sh))),
    ];
  });
  expect(centre(dark)).toEqual([0, 0, 0]);
  expect(difference(dark, rectangular)).toBe(0);
  expect(Math.abs(centre(probe)[0] - 128)).toBeLessThanOrEqual(1);
});

test('reflected light knows no shadow', async ({ page }) => {
  const [shaded, opened] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const floor = await hatchedMesh(new THREE.PlaneGeometry(3, 3));
    const blocker = await hatchedMesh(new THREE.BoxGeometry(0.5, 0.5, 0.2));
    blocker.position.set(1.2, 0, 1.2);
    blocker.castShadow = true;
    floor.receiveShadow = true;
    const light = sun(Math.PI, [3, 0, 3]);
    light.castShadow = true;
    const renderer = makeRenderer();
    renderer.shadowMap.enabled = true;
    const scene = sceneOf(floor, blocker, light);
    const shaded = pixelsOf(scene, renderer);
    floor.material.reflectedLight = 1;
    return [shaded, pixelsOf(scene, renderer)];
  });
  expect(centre(shaded)[0]).toBeLessThan(10);
  // (1 − cos 45°) / 2 of the light.
  expect(Math.abs(centre(opened)[0] - 255 * 0.1464)).toBeLessThanOrEqual(2);
});

for (const technique of ['triangle', 'adjacency', 'hatching'] as const) {
  for (const crisp of technique === 'hatching' ? [false] : [false, true]) {
    test(
      `a second layer: none with one light, and the same tone with two: ${technique}${crisp ? ', crisp' : ''}`,
      quickIf(technique === 'hatching' || (technique === 'adjacency' && crisp)),
      async ({ page }) => {
        const { one, oneLayered, two, twoLayered, means } = await page.evaluate(
          async ([technique, crisp]) => {
            const { THREE, TonalArtMap, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
            const tonalArtMap = await TonalArtMap.generate({ size: 128 });
            const renderer = makeRenderer();
            const tilesPerObjectUnit = 0.6;
            // The same place in the world, which is another on the object, with other anchors.
            const wallAt = async (depth: number, strokeLayers: 'single' | 'lights') => {
              const geometry = new THREE.PlaneGeometry(4, 4).translate(0, 0, depth);
              const wall = await hatchedMesh(geometry, {
                tonalArtMap,
                technique,
                perTriangle: { sharpInk: crisp },
                strokeLayers,
                tilesPerObjectUnit,
              });
              wall.position.z = -depth;
              return wall;
            };
            const left = () => sun(Math.PI / 3, [-1, 0, 1]);
            const above = () => sun(Math.PI / 4, [0, 1, 1]);
            const underTwo = async (strokeLayers: 'single' | 'lights', depth = 0) =>
              pixelsOf(sceneOf(await wallAt(depth, strokeLayers), left(), above()), renderer);
            const meanInk = async (strokeLayers: 'single' | 'lights') => {
              const pixels: number[] = [];
              for (const depth of technique === 'hatching' ? [0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22] : [0])
                pixels.push(...(await underTwo(strokeLayers, depth)));
              return pixels.reduce((sum, x, i) => (i % 4 === 0 ? sum + x : sum), 0) / (255 * (pixels.length / 4));
            };
            return {
              one: pixelsOf(sceneOf(await wallAt(0, 'single'), left())),
              oneLayered: pixelsOf(sceneOf(await wallAt(0, 'lights'), left())),
              two: await underTwo('single'),
              twoLayered: await underTwo('lights'),
              means: [await meanInk('single'), await meanInk('lights')],
            };
          },
          [technique, crisp] as const,
        );
        expect(difference(one, oneLayered), 'one light').toBe(0);
        expect(difference(two, twoLayered), 'two lights').toBeGreaterThan(100);
        // Crisp blending takes neighbours for independent, which on a flat wall they are not: its tone is not exact there.
        const tolerance = technique === 'adjacency' && crisp ? 0.05 : 0.02;
        expect(Math.abs(means[0] - means[1]), 'mean ink').toBeLessThan(tolerance);
        // The stronger light is on the left: strokes run up and down. The second layer runs across.
        const [before, after] = [two, twoLayered].map((pixels) => {
          let [alongRows, alongColumns] = [0, 0];
          for (let i = 4 * 96; i < pixels.length; i += 4) {
            alongRows += Math.abs(pixels[i] - pixels[i - 4]);
            alongColumns += Math.abs(pixels[i] - pixels[i - 4 * 96]);
          }
          return alongRows / alongColumns;
        });
        expect(before).toBeGreaterThan(1.8);
        expect(after).toBeLessThan(1.5);
        expect(after).toBeGreaterThan(0.9);
        expect(covered(twoLayered)).toBeGreaterThan(9000);
      },
    );
  }
}

for (const technique of ['triangle', 'adjacency', 'hatching'] as const) {
  for (const crisp of technique === 'hatching' ? [false] : [false, true]) {
    test(
      `layers by tone: one up to where they cross, and the same tone beyond: ${technique}${crisp ? ', crisp' : ''}`,
      quickIf(technique === 'hatching' || (technique === 'triangle' && !crisp)),
      async ({ page }) => {
        const shown = await page.evaluate(
          async ([technique, crisp]) => {
            const { THREE, TonalArtMap, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
            const tonalArtMap = await TonalArtMap.generate({ size: 128 });
            const light = sun(1, [-1, 0, 1]);
            const wall = await hatchedMesh(new THREE.PlaneGeometry(4, 4), {
              tonalArtMap,
              technique,
              perTriangle: { sharpInk: crisp },
              tilesPerObjectUnit: 2,
            });
            const renderer = makeRenderer();
            const scene = sceneOf(wall, light);
            const show = (tone: number, strokeLayers: 'single' | 'tone') => {
              light.intensity = Math.PI * Math.SQRT2 * (1 - tone);
              wall.material.strokeLayers = strokeLayers;
              return pixelsOf(scene, renderer);
            };
            wall.material.crossFrom = 0.4;
            return {
              below: [show(0.39, 'single'), show(0.39, 'tone')],
              beginning: [show(0.41, 'single'), show(0.41, 'tone')],
              beyond: [0.55, 0.65, 0.75, 0.9].map((tone) => ({
                tone,
                single: show(tone, 'single'),
                layered: show(tone, 'tone'),
              })),
            };
          },
          [technique, crisp] as const,
        );
        const ink = (pixels: number[]) =>
          1 - pixels.reduce((sum, x, i) => (i % 4 === 0 ? sum + x : sum), 0) / (255 * 96 * 96);
        const [below, crossedBelow] = shown.below;
        expect(difference(below, crossedBelow), 'below').toBe(0);
        // A layer begins as hairs: nothing pops.
        const [beginning, crossedBeginning] = shown.beginning;
        const share = differing(beginning, crossedBeginning, 60) / (96 * 96);
        expect(share, 'changed at its beginning').toBeLessThan(0.05);
        for (const { tone, single, layered } of shown.beyond) {
          expect(differing(single, layered, 60) / (96 * 96), 'changed').toBeGreaterThan(0.05);
          // Hatch images end at an ink of 0.95, and crisp blending takes neighbours for independent, which on a flat wall they are
          // not: there a single layer is not exact either.
          const tolerance = Math.max(0.02, Math.abs(ink(single) - tone) + 0.015);
          expect(Math.abs(ink(layered) - tone), `ink at ${tone}`).toBeLessThan(tolerance);
          if (technique === 'hatching') expect(tolerance).toBeLessThan(0.035);
        }
      },
    );
  }
}

for (const technique of ['adjacency', 'hatching'] as const) {
  for (const degrees of [60, 90]) {
    test(
      `layers by tone run at the angles they are asked for: ${technique}, ${degrees}°`,
      quickIf(degrees === 60),
      async ({ page }) => {
        const [one, two] = await page.evaluate(
          async ([technique, degrees]) => {
            const { THREE, TonalArtMap, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
            const tonalArtMap = await TonalArtMap.generate({ size: 128, style: 'ruled' });
            const show = async (tone: number, crossFrom: number) =>
              pixelsOf(
                sceneOf(
                  await hatchedMesh(new THREE.PlaneGeometry(4, 4), {
                    tonalArtMap,
                    technique,
                    ...(technique === 'adjacency' && { perTriangle: { sharpInk: true } }),
                    tilesPerObjectUnit: 0.5,
                    edgePixels: 3,
                    strokeLayers: 'tone',
                    crossFrom,
                    crossAngle: (degrees * Math.PI) / 180,
                  }),
                  sun(Math.PI * Math.SQRT2 * (1 - tone), [-1, 0, 1]),
                ),
              );
            return [await show(0.3, 1), await show(0.4, 0)];
          },
          [technique, degrees] as const,
        );
        // The light is on the left: the first run up and down.
        expectAngles(one, [90]);
        expectAngles(two, [90, 90 - degrees]);
      },
    );
  }
}

/** Strokes run along these directions, in degrees from a row, counter-clockwise, and along no others. */
function expectAngles(pixels: number[], angles: number[]): void {
  // The change of brightness, by the direction along which it is constant, in steps of 5°.
  const histogram = new Float64Array(36);
  const value = (x: number, y: number) => pixels[4 * (y * 96 + x)];
  for (let y = 1; y < 95; y++) {
    for (let x = 1; x < 95; x++) {
      // Sobel's gradient.
      let [gx, gy] = [0, 0];
      for (const k of [-1, 0, 1]) {
        gx += (2 - Math.abs(k)) * (value(x + 1, y + k) - value(x - 1, y + k));
        gy += (2 - Math.abs(k)) * (value(x + k, y + 1) - value(x + k, y - 1));
      }
      const along = (Math.atan2(gy, gx) * 180) / Math.PI + 90;
      histogram[Math.floor(along / 5 + 36) % 36] += Math.hypot(gx, gy);
    }
  }
  const bin = (i: number) => histogram[(i + 72) % 36];
  // Bins on either side of an angle.
  const around = (degrees: number) => bin(degrees / 5 - 1) + bin(degrees / 5);
  const weakest = Math.min(...angles.map(around));
  for (let degrees = 0; degrees < 180; degrees += 5) {
    const away = Math.min(...angles.map((angle) => Math.abs(((degrees - angle + 270) % 180) - 90)));
    if (away > 20) expect(around(degrees) / weakest, `along ${degrees}°`).toBeLessThan(0.75);
  }
}
