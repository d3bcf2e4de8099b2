import { expect } from '../browser/test.js';
import { at, centre, covered, difference } from './pixels.js';
import { test } from './toolkitPage.js';

/** From new to disposed: copies, renderers, frames without waste, and what is drawn where something is missing or extreme. */

test('clone and copy draw the same picture', async ({ page }) => {
  const [original, cloned, copied] = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, hatchedMesh, stripedMap, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const mesh = await hatchedMesh(new THREE.TorusGeometry(0.6, 0.3, 12, 24), {
      tonalArtMap: stripedMap(),
      tilesPerObjectUnit: 2,
      strokeAngle: 0.3,
      technique: 'triangle',
      ink: 'darkred',
    });
    const scene = sceneOf(mesh, sun());
    const original = pixelsOf(scene, renderer);
    const textures = renderer.info.memory.textures;
    mesh.material = mesh.material.clone();
    const cloned = pixelsOf(scene, renderer);
    mesh.material = new HatchingMaterial().copy(mesh.material);
    const copied = pixelsOf(scene, renderer);
    if (renderer.info.memory.textures !== textures) throw new Error('a clone uploaded its map again');
    return [original, cloned, copied];
  });
  expect(difference(original, cloned)).toBe(0);
  expect(difference(original, copied)).toBe(0);
});

test('two renderers on one page share geometry, material and map', async ({ page }) => {
  const [a, b] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, stripedMap, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const mesh = await hatchedMesh(new THREE.TorusGeometry(0.6, 0.3, 12, 24), { tonalArtMap: stripedMap() });
    const scene = sceneOf(mesh, sun());
    return [pixelsOf(scene, makeRenderer()), pixelsOf(scene, makeRenderer())];
  });
  expect(covered(a)).toBeGreaterThan(800);
  expect(difference(a, b)).toBe(0);
});

test('several materials and a plain one share a scene', async ({ page }) => {
  const pixels = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
    const left = await hatchedMesh(new THREE.PlaneGeometry(0.5, 1), { color: 'red', technique: 'triangle' });
    const right = await hatchedMesh(new THREE.PlaneGeometry(0.5, 1), { color: 'blue', toneModel: 'toon' });
    const plain = new THREE.Mesh(new THREE.PlaneGeometry(0.5, 1), new THREE.MeshLambertMaterial());
    left.position.x = -0.7;
    right.position.x = 0.7;
    return pixelsOf(sceneOf(left, plain, right, sun(Math.PI, [0, 0, 1])));
  });
  expect(at(pixels, 25, 48)).toEqual([255, 0, 0]);
  expect(centre(pixels)).toEqual([255, 255, 255]);
  expect(at(pixels, 71, 48)).toEqual([0, 0, 255]);
});

test('dispose frees all GPU objects', async ({ page }) => {
  const [during, after] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const mesh = await hatchedMesh(new THREE.BoxGeometry());
    pixelsOf(sceneOf(mesh, sun()), renderer);
    const count = () => [
      renderer.info.memory.geometries,
      renderer.info.memory.textures,
      renderer.info.programs!.length,
    ];
    const during = count();
    mesh.geometry.dispose();
    (mesh.material.tonalArtMap as import('three-hatching').TonalArtMap).dispose();
    mesh.material.dispose();
    return [during, count()];
  });
  expect(Math.min(...during!.slice(0, 1))).toBeGreaterThan(0);
  expect(after[0]).toBe(0);
  expect(after[1]).toBeLessThan(during[1]);
  expect(after[2]).toBeLessThan(during[2]);
});

test('a slider does not recompile, and a frame allocates no textures or geometries', async ({ page }) => {
  const [programs, calls] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const mesh = await hatchedMesh(new THREE.SphereGeometry(1, 16, 12), {
      toneCurve: [
        [0, 0],
        [1, 0.5],
      ],
    });
    const light = sun();
    const scene = sceneOf(mesh, light);
    pixelsOf(scene, renderer);
    const gl = renderer.getContext() as WebGL2RenderingContext;
    let compiled = 0;
    let uploaded = 0;
    for (const name of ['compileShader', 'linkProgram'] as const) {
      const call = gl[name].bind(gl) as (x: WebGLShader & WebGLProgram) => void;
      gl[name] = (x: WebGLShader & WebGLProgram) => {
        compiled++;
        call(x);
      };
    }
    for (const name of ['bufferData', 'texSubImage3D', 'texSubImage2D'] as const) {
      const call = (gl[name] as (...args: unknown[]) => void).bind(gl);
      (gl as unknown as Record<string, unknown>)[name] = (...args: unknown[]) => {
        uploaded++;
        call(...args);
      };
    }
    for (let i = 0; i < 5; i++) {
      mesh.material.tilesPerObjectUnit = 2 + i;
      mesh.material.strokeAngle = i;
      mesh.material.perTriangle.strokeOffset.x = i / 5;
      mesh.material.ink.setRGB(i / 5, 0, 0);
      mesh.material.toneSteps = 2 + i;
      mesh.material.perTriangle.blendAngle = 0.2 + i / 5;
      mesh.material.reflectedLight = i / 5;
      mesh.material.paperOpacity = i / 5;
      mesh.material.toneCurve = [
        [0, i / 10],
        [1, 1],
      ];
      light.position.x = i;
      renderer.render(scene, new THREE.PerspectiveCamera());
    }
    return [compiled, uploaded];
  });
  expect(programs).toBe(0);
  // Each new tone curve is written into the table that is there.
  expect(calls).toBe(5);
});

for (const technique of ['triangle', 'adjacency', 'hatching'] as const) {
  test(`scale, rotation and shift count from the next frame on, for their material alone: ${technique}`, async ({
    page,
  }) => {
    const { before, after, fresh } = await page.evaluate(async (technique) => {
      const { THREE, hatchedMesh, stripedMap, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
      const renderer = makeRenderer();
      const tonalArtMap = stripedMap();
      const common = { tonalArtMap, technique, tilesPerObjectUnit: 2, toneNormal: 'smooth' } as const;
      const changed = { tilesPerObjectUnit: 1.3, strokeAngle: 0.7 };
      const offset = new THREE.Vector2(0.1, 0.3);
      const sphere = () => new THREE.SphereGeometry(0.6, 24, 16);
      const left = await hatchedMesh(sphere(), common);
      const right = await hatchedMesh(sphere(), common);
      left.position.x = -0.7;
      right.position.x = 0.7;
      const scene = sceneOf(left, right, sun());
      const before = pixelsOf(scene, renderer);
      right.material.tilesPerObjectUnit = changed.tilesPerObjectUnit;
      right.material.strokeAngle = changed.strokeAngle;
      right.material.perTriangle.strokeOffset.copy(offset);
      const after = pixelsOf(scene, renderer);
      right.material = new window.toolkit.HatchingMaterial({ ...common, ...changed });
      right.material.perTriangle.strokeOffset.copy(offset);
      return { before, after, fresh: pixelsOf(scene, renderer) };
    }, technique);
    const half = (pixels: number[], right: boolean) => pixels.filter((_, i) => Math.floor(i / 4) % 96 >= 48 === right);
    expect(difference(after, fresh)).toBe(0);
    expect(difference(half(before, false), half(after, false))).toBe(0);
    const now = half(after, true);
    const moved = half(before, true).filter((x, i) => Math.abs(x - now[i]) > 100).length;
    expect(moved).toBeGreaterThan(300);
  });
}

test('a mesh of an unprepared geometry is named in the console, once', async ({ page, pageProblems }) => {
  await page.evaluate(async () => {
    const { THREE, HatchingMaterial, greyMap, sceneOf, sun, pixelsOf, makeRenderer, whenChecked } = window.toolkit;
    HatchingMaterial.silent = false;
    const renderer = makeRenderer();
    const crate = new THREE.Mesh(new THREE.BoxGeometry(), new HatchingMaterial({ tonalArtMap: greyMap() }));
    crate.name = 'crate';
    const scene = sceneOf(crate, sun());
    pixelsOf(scene, renderer);
    pixelsOf(scene, renderer);
    await whenChecked();
  });
  const problems = pageProblems.splice(0);
  expect(problems).toHaveLength(1);
  expect(problems[0]).toContain('the Mesh "crate" at Scene/crate has no triangle adjacency');
});

test('anchored draws a geometry that was never prepared, by its own normals', async ({ page }) => {
  const [plain, grey] = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, stripedMap, sceneOf, sun, pixelsOf } = window.toolkit;
    const material = new HatchingMaterial({
      tonalArtMap: stripedMap(),
      technique: 'hatching',
      edgePixels: 0,
      tilesPerObjectUnit: 2,
    });
    const pixels = pixelsOf(sceneOf(new THREE.Mesh(new THREE.SphereGeometry(1, 32, 24), material), sun()));
    let inked = 0;
    let grey = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      if (pixels[i] === pixels[i + 1] && pixels[i] === 0) inked++;
      if (pixels[i] !== 0 && pixels[i] !== 255) grey++;
    }
    return [inked, grey];
  });
  expect(plain).toBeGreaterThan(500);
  expect(grey).toBeLessThan(5);
});

test('without a map the surface stays paper', async ({ page }) => {
  const pixels = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
    return pixelsOf(
      sceneOf(await hatchedMesh(new THREE.PlaneGeometry(2, 2), { tonalArtMap: null, paper: 'gold' }), sun()),
    );
  });
  expect(centre(pixels)[0]).toBe(255);
  expect(centre(pixels)[2]).toBe(0);
});

test('a surface is blank paper until its map is drawn, and hatched in the next frame, by the same program', async ({
  page,
}) => {
  const outcomes = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer, TonalArtMap } = window.toolkit;
    const inkIn = (pixels: number[]): number => pixels.filter((_, i) => i % 4 === 1 && pixels[i]! < 128).length;
    const outcomes: Record<string, number[]> = {};
    for (const look of [
      { technique: 'hatching' },
      { technique: 'dryMedia' },
      { technique: 'adjacency' },
      { technique: 'triangle', perTriangle: { sharpInk: true } },
    ] as const) {
      const renderer = makeRenderer();
      const mesh = await hatchedMesh(new THREE.SphereGeometry(1, 32, 24), look);
      // The side turned away from this light is as dark as can be.
      const scene = sceneOf(mesh, sun(Math.PI, [1, 0, 0]));
      const tonalArtMap = TonalArtMap.draw({ size: 64 });
      mesh.material.tonalArtMap = tonalArtMap;
      const before = inkIn(pixelsOf(scene, renderer));
      const { textures } = renderer.info.memory;
      const { version } = mesh.material;
      await tonalArtMap.ready;
      const after = inkIn(pixelsOf(scene, renderer));
      pixelsOf(scene, renderer);
      outcomes[JSON.stringify(look)] = [
        before,
        after,
        mesh.material.version - version,
        renderer.info.memory.textures - textures,
      ];
    }
    return outcomes;
  });
  for (const [look, [before, after, programs, textures]] of Object.entries(outcomes)) {
    expect(before, look).toBe(0);
    expect(after, look).toBeGreaterThan(600);
    expect([programs, textures], look).toEqual([0, 1]);
  }
});

test('degenerate, tiny, huge and far meshes give no NaN and no error', async ({ page }) => {
  const counts = await page.evaluate(async () => {
    const { THREE, hatchedMesh, stripedMap, sceneOf, sun, pixelsOf } = window.toolkit;
    const results: number[][] = [];
    for (const scale of [1e-6, 1e-3, 1e3, 1e6]) {
      const geometry = new THREE.SphereGeometry(1, 16, 12).scale(scale, scale, scale);
      const mesh = await hatchedMesh(geometry, {
        tonalArtMap: stripedMap(),
        tilesPerObjectUnit: 2 / scale,
        ink: 'blue',
      });
      mesh.scale.setScalar(1 / scale);
      const pixels = pixelsOf(sceneOf(mesh, sun()));
      const seen = new Set<string>();
      for (let i = 0; i < pixels.length; i += 4) seen.add(pixels.slice(i, i + 3).join());
      results.push([seen.size, pixels.filter((_, i) => i % 4 === 1 && pixels[i + 1] === 255).length]);
    }
    return results;
  });
  for (const [colours, inked] of counts) {
    expect(colours).toBeGreaterThan(2);
    expect(inked).toBeGreaterThan(500);
  }
});
