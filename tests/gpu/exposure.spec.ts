import * as three from 'three';
import { fitExposure } from '../../src/scene/fitExposure.js';
import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { covered, difference, isGround, SIZE } from './pixels.js';
import { techniques } from './techniques.js';
import { test } from './toolkitPage.js';

/** The exposure that is fitted to a scene, as it is drawn. */

/** The tones of a picture of tones, without the background. */
function tonesOf(pixels: number[]): number[] {
  const tones: number[] = [];
  for (let i = 0; i < 4 * SIZE * SIZE; i += 4) if (!isGround(pixels.slice(i, i + 3))) tones.push(1 - pixels[i] / 255);
  return tones;
}

for (const technique of techniques) {
  test(
    `a ball is the same picture in a light of any intensity: ${technique}`,
    quickIf(technique === 'adjacency' || technique === 'engraving'),
    async ({ page }) => {
      const [first, ...others] = await page.evaluate(async (technique) => {
        const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
        const renderer = makeRenderer();
        const light = sun();
        const geometry = new THREE.SphereGeometry(1, 64, 32);
        const scene = sceneOf(
          await hatchedMesh(geometry, { technique, debugView: 'tone', composition: { exposure: 'auto' } }),
          light,
        );
        return [Math.PI, 0.03, 1, 50].map((intensity) => {
          light.intensity = intensity;
          return pixelsOf(scene, renderer);
        });
      }, technique);
      expect(covered(first)).toBeGreaterThan(1000);
      const tones = tonesOf(first);
      expect(Math.min(...tones)).toBeLessThan(0.05);
      expect(Math.max(...tones)).toBe(1);
      for (const pixels of others) expect(difference(first, pixels)).toBeLessThanOrEqual(1);
    },
  );
}

test('the exposure stays as it is while the camera moves, and is what it was when a light comes back', async ({
  page,
}) => {
  const { moved, dragged, fitted } = await page.evaluate(async () => {
    const { THREE, fitExposure, hatchedMesh, sceneOf, sun, makeRenderer, makeCamera } = window.toolkit;
    const renderer = makeRenderer();
    const light = sun(1);
    const mesh = await hatchedMesh(new THREE.TorusGeometry(1, 0.4), {
      technique: 'engraving',
      composition: { exposure: 'auto' },
    });
    const scene = sceneOf(mesh, light, new THREE.HemisphereLight(0xffffff, 0x222222, 1));
    const camera = makeCamera();
    const draw = (): number[] => {
      renderer.render(scene, camera);
      const { exposure, colorExposure } = mesh.material.uniforms;
      return [...exposure.value.toArray(), colorExposure.value];
    };
    const wanted = (): number[] => {
      const { scale, offset, white } = fitExposure(scene);
      return [scale, offset, 1 / white];
    };
    const moved = [0, 1, 2, 3].map((i) => {
      camera.position.set(Math.sin(i), i, 3 + i);
      camera.lookAt(0, 0, 0);
      return draw();
    });
    const dragged = [0, 1, 2, 0].map((i) => {
      light.position.set(1 + i, 1.5 - i, 2);
      return { drawn: draw(), function: wanted() };
    });
    return { moved, dragged, fitted: wanted() };
  });
  for (const exposure of moved) expect(exposure).toEqual(fitted);
  for (const exposure of dragged) expect(exposure.drawn).toEqual(exposure.function);
  expect(dragged[1].drawn).not.toEqual(fitted);
  expect(dragged[3].drawn).toEqual(fitted);
});

/** A scene with everything that the fit reads, except for features of browsers; its code runs in Node too. */
function sceneOfAll({ THREE }: { THREE: typeof three }): three.Scene {
  const material = (reflectedLight: number) =>
    Object.assign(new THREE.MeshStandardMaterial(), {
      ...{ isHatchingMaterial: true, composition: { exposure: 'auto' }, toneModel: 'lambert', toneCurve: 'printed' },
      ...{ reflectedLight, occlusion: 0 },
    });
  const scene = new THREE.Scene();
  const knot = new THREE.Mesh(new THREE.TorusKnotGeometry(1, 0.4, 200, 24), material(0.3));
  knot.rotation.set(1, 2, 3);
  knot.scale.set(1, 2, 0.5);
  const box = new THREE.Mesh(new THREE.BoxGeometry(2, 1, 1), material(0));
  box.position.set(3, 0, 0);
  const sun = new THREE.DirectionalLight(0xffeedd, 2);
  sun.position.set(1, 2, 3);
  const lamp = new THREE.PointLight(0xff8844, 40, 20, 1.7);
  lamp.position.set(-2, 3, 1);
  const spot = new THREE.SpotLight(0xffffff, 90, 0, 0.5, 0.4);
  spot.position.set(2, 5, 2);
  const probe = new THREE.LightProbe();
  for (const [i, color] of probe.sh.coefficients.entries()) color.setScalar(0.2 / (i + 1));
  const data = Float32Array.from({ length: 4 * 16 * 8 }, (_, i) => 0.5 + 0.5 * Math.sin(i));
  scene.environment = new THREE.DataTexture(data, 16, 8, THREE.RGBAFormat, THREE.FloatType);
  scene.environment.mapping = THREE.EquirectangularReflectionMapping;
  scene.environmentRotation.set(0.1, 0.7, 0);
  const sky = new THREE.HemisphereLight(0x8899ff, 0x443322, 0.7);
  return scene.add(knot, box, sun, lamp, spot, probe, sky, new THREE.AmbientLight(0xffffff, 0.1));
}

test('the function is the same in Node and in the browser', async ({ page }) => {
  const inBrowser = await page.evaluate((source) => {
    // biome-ignore lint/security/noGlobalEval: it is the function above.
    const sceneOfAll = eval(`(${source})`);
    return window.toolkit.fitExposure(sceneOfAll(window.toolkit));
  }, sceneOfAll.toString());
  const inNode = fitExposure(sceneOfAll({ THREE: three }));
  expect(inNode.scale).not.toBe(1);
  expect(inBrowser.scale).toBeCloseTo(inNode.scale, 9);
  expect(inBrowser.offset).toBeCloseTo(inNode.offset, 9);
});

test("a scene for physically based rendering, lit by three's defaults, has lights, half tones and darks", {
  tag: '@all',
}, async ({ page }) => {
  // A software rasterizer takes its time over blurring the room.
  test.slow();
  const shown = await page.evaluate(async () => {
    const { THREE, RoomEnvironment, hatchedMesh, sceneOf, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment()).texture;
    const mesh = await hatchedMesh(new THREE.TorusKnotGeometry(0.8, 0.3, 96, 16), {
      ...{ technique: 'hatching', debugView: 'tone' },
    });
    const lights = [
      new THREE.DirectionalLight(),
      new THREE.PointLight(),
      new THREE.HemisphereLight(),
      new THREE.AmbientLight(),
    ];
    lights[1].position.set(2, 2, 2);
    const pictures: Record<string, number[][]> = {};
    for (const [name, things, withRoom] of [
      ['room', [], true],
      ['room and lights', lights, true],
      ['lights', lights, false],
      ['one light', lights.slice(0, 1), false],
    ] as const) {
      const scene = sceneOf(mesh, ...things);
      if (withRoom) scene.environment = environment;
      pictures[name] = ([1, 'auto'] as const).map((exposure) => {
        mesh.material.composition.exposure = exposure;
        return pixelsOf(scene, renderer);
      });
    }
    return pictures;
  });
  const report: Record<string, string[]> = {};
  for (const [name, pictures] of Object.entries(shown)) {
    const shares = pictures.map((pixels) => {
      const tones = tonesOf(pixels);
      const share = (from: number, to: number) =>
        tones.filter((tone) => tone >= from && tone <= to).length / tones.length;
      return { lights: share(0, 0.25), half: share(0.25, 0.75), darks: share(0.75, 1) };
    });
    report[name] = shares.map((share) => JSON.stringify(share));
    test.info().annotations.push({ type: name, description: report[name].join(' ') });
    const [bare, auto] = shares;
    expect(Math.max(bare.lights, bare.darks, bare.half), name).toBeGreaterThan(0.7);
    for (const [part, share] of Object.entries(auto)) expect(share, `${name}: ${part}`).toBeGreaterThan(0.05);
  }
});

test('a tone curve by hand has the light as it is', async ({ page }) => {
  const [fixed, auto] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const toneCurve = [
      [0, 0],
      [0.5, 0.2],
      [1, 0.9],
    ] as const;
    const mesh = await hatchedMesh(new THREE.SphereGeometry(), { technique: 'hatching', debugView: 'tone', toneCurve });
    const scene = sceneOf(mesh, sun(1));
    return ([1, 'auto'] as const).map((exposure) => {
      mesh.material.composition.exposure = exposure;
      return pixelsOf(scene, renderer);
    });
  });
  expect(auto).toEqual(fixed);
});

test('hiding, colouring, adding and taking a part changes no other part, until the exposure is fitted again', async ({
  page,
}) => {
  const { fit, auto } = await page.evaluate(async (size) => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    /** The ink of the left part while the right one changes, and after the exposure was fitted again. */
    const inkOf = async (exposure: 'fit' | 'auto'): Promise<number[]> => {
      const { composition } = new window.toolkit.UsersMaterial({ composition: { exposure } });
      const part = async (x: number, color: number) => {
        const mesh = await hatchedMesh(new THREE.SphereGeometry(0.45, 48, 24), {
          ...{ technique: 'engraving', debugView: 'tone', colorHatching: 0.8, colorFill: 0, composition, color },
        });
        mesh.position.x = x;
        return mesh;
      };
      const [left, right] = [await part(-0.5, 0x808080), await part(0.5, 0xffffff)];
      const scene = sceneOf(left, right, sun(0.7));
      const ink = (): number => {
        const pixels = pixelsOf(scene, renderer);
        let sum = 0;
        for (let i = 0; i < pixels.length; i += 4) {
          const isLeft = (i / 4) % size < size / 2;
          if (isLeft && pixels[i] === pixels[i + 1]) sum += 255 - pixels[i];
        }
        return sum;
      };
      const inks = [ink()];
      right.visible = false;
      inks.push(ink());
      right.visible = true;
      right.material.color.set(0x202020);
      inks.push(ink());
      const third = await part(0.5, 0xffffff);
      third.position.y = 1;
      scene.add(third);
      inks.push(ink());
      scene.remove(third, right);
      inks.push(ink());
      composition.refit();
      return [...inks, ink()];
    };
    return { fit: await inkOf('fit'), auto: await inkOf('auto') };
  }, SIZE);
  const [first, ...others] = fit;
  expect(first).toBeGreaterThan(0);
  for (const ink of others.slice(0, -1)) expect(Math.abs(ink / first - 1)).toBeLessThan(0.01);
  expect(Math.abs(others.at(-1)! / first - 1)).toBeGreaterThan(0.1);
  expect(auto[0]).toBe(first);
  expect(Math.abs(auto[1] / first - 1)).toBeGreaterThan(0.1);
});
