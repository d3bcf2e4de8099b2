import type { Camera } from 'three';
import { expect } from '../browser/test.js';
import { covered, differing, isGround, SIZE } from './pixels.js';
import { test } from './toolkitPage.js';

/** Large meshes drawn with no more triangles than can be seen. */

/** The URL of meshoptimizer on the test server. */
const SIMPLIFIER = '/node_modules/meshoptimizer/meshopt_simplifier.js';

/** The number of pixels that are other than the one to the right of them, or the one above. */
const edges = (pixels: number[]): number => {
  let count = 0;
  for (let i = 0; i < 4 * SIZE * (SIZE - 1); i += 4) {
    const differs = (by: number): boolean =>
      [0, 1, 2].some((channel) => Math.abs(pixels[i + channel] - pixels[i + by + channel]) > 32);
    if (differs(4) || differs(4 * SIZE)) count++;
  }
  return count;
};

test('levels are drawn by distance, look as the whole mesh does, and change no more on the way', async ({ page }) => {
  const { views, wholeOnce, restored, memory } = await page.evaluate(async (simplifier) => {
    const { THREE, applyHatching, sceneOf, sun, pixelsOf, makeRenderer, makeCamera } = window.toolkit;
    const knot = () => new THREE.TorusKnotGeometry(0.6, 0.22, 1200, 120);
    const renderer = makeRenderer();
    const use = () => ({ ...renderer.info.memory });
    const memory = [use()];
    const scenes = [];
    for (const detail of [undefined, { simplifier }]) {
      const mesh = new THREE.Mesh(knot(), new THREE.MeshStandardMaterial());
      const hatched = await applyHatching(mesh, { detail, tilesPerWorldUnit: 2 });
      scenes.push({ mesh, hatched, scene: sceneOf(sun(), mesh) });
    }
    const [whole, leveled] = scenes;
    const views = [];
    for (const distance of [1.6, 3, 3.1, 6, 6.2, 12, 12.2]) {
      const camera = makeCamera();
      camera.position.z = distance;
      const pictures = scenes.map(({ scene }) => {
        const pixels = pixelsOf(scene, renderer, camera);
        return { pixels, triangles: renderer.info.render.triangles };
      });
      views.push(pictures);
    }
    // Between draws the geometry is the whole mesh.
    const { index, drawRange } = leveled.mesh.geometry;
    const wholeOnce = index!.count === whole.mesh.geometry.index!.count && drawRange.count === Infinity;
    const camera = makeCamera();
    camera.position.z = 12;
    leveled.hatched.restore();
    leveled.mesh.geometry = whole.mesh.geometry;
    leveled.mesh.material = whole.mesh.material;
    pixelsOf(leveled.scene, renderer, camera);
    const restored = renderer.info.render.triangles;
    for (const { hatched } of scenes) hatched.dispose();
    memory.push(use());
    return { views, wholeOnce, restored, memory };
  }, SIMPLIFIER);
  const triangles = views.map(([, { triangles }]) => triangles);
  expect(views.every(([{ triangles }]) => triangles === 288_000)).toBe(true);
  expect(triangles.toSorted((a, b) => b - a)).toEqual(triangles);
  expect(triangles.at(-1)).toBeLessThan(20_000);
  expect(new Set(triangles).size).toBeGreaterThan(2);
  for (const [{ pixels: whole }, { pixels: leveled }] of views) {
    expect(covered(whole)).toBeGreaterThan(50);
    // A shift by a third of a pixel changes a third of the pixels at edges, of shapes and of strokes.
    expect(differing(whole, leveled, 32)).toBeLessThan(edges(whole) / 3);
  }
  // A step of the camera, across levels too: what flips in the whole mesh may flip, and hardly anything else.
  for (const i of [1, 3, 5]) {
    const [flips, leveledFlips] = [0, 1].map((kind) => differing(views[i][kind].pixels, views[i + 1][kind].pixels, 32));
    expect(leveledFlips).toBeLessThanOrEqual(1.03 * flips);
  }
  expect(wholeOnce).toBe(true);
  expect(restored).toBe(288_000);
  expect(memory[1].geometries).toBe(memory[0].geometries);
});

test('lines along the form lie in levels where they lie in the whole mesh', { tag: '@all' }, async ({ page }) => {
  const views = await page.evaluate(async (simplifier) => {
    const { THREE, applyHatching, sceneOf, sun, pixelsOf, makeRenderer, makeCamera } = window.toolkit;
    const renderer = makeRenderer();
    // A shape whose field has singular points, and cuts between them.
    const lump = () => {
      const geometry = new THREE.SphereGeometry(1, 512, 256);
      const { position } = geometry.attributes;
      const p = new THREE.Vector3();
      for (let i = 0; i < position.count; i++) {
        p.fromBufferAttribute(position, i);
        p.multiplyScalar(0.75 + 0.12 * Math.sin(4 * p.x + 1) * Math.sin(5 * p.y) + 0.1 * Math.sin(3 * p.z));
        position.setXYZ(i, p.x, p.y, p.z);
      }
      return geometry.deleteAttribute('normal').deleteAttribute('uv');
    };
    const hatchedScene = async (detail: { simplifier: string } | undefined) => {
      const mesh = new THREE.Mesh(lump(), new THREE.MeshStandardMaterial());
      const hatched = await applyHatching(mesh, {
        detail,
        material: { technique: 'engraving', direction: 'form', lineSpacing: 4 },
      });
      const formed = await hatched.formReady;
      return { hatched, formed: formed.length, scene: sceneOf(sun(), mesh) };
    };
    const scenes = [await hatchedScene(undefined), await hatchedScene({ simplifier })];
    const views = [1.6, 3, 3.1, 6, 6.2, 12].map((distance) => {
      const camera = makeCamera();
      camera.position.z = distance;
      return scenes.map(({ scene, formed }) => {
        const pixels = pixelsOf(scene, renderer, camera);
        return { pixels, formed, triangles: renderer.info.render.triangles };
      });
    });
    for (const { hatched } of scenes) hatched.dispose();
    return views;
  }, SIMPLIFIER);
  for (const [whole, leveled] of views) {
    expect([whole.formed, leveled.formed]).toEqual([1, 1]);
    expect(edges(whole.pixels)).toBeGreaterThan(100);
    expect(differing(whole.pixels, leveled.pixels, 32)).toBeLessThan(edges(whole.pixels) / 30);
  }
  const triangles = views.map(([, leveled]) => leveled.triangles);
  expect(triangles[0]).toBeLessThan(0.6 * views[0][0].triangles);
  expect(triangles.at(-1)).toBeLessThan(0.04 * views[0][0].triangles);
});

test('two cameras, shadows, clones and rays: each sees its own level or the whole mesh', { tag: '@all' }, async ({
  page,
}) => {
  const { counts, hits } = await page.evaluate(async (simplifier) => {
    const { THREE, applyHatching, sceneOf, sun, pixelsOf, makeRenderer, makeCamera } = window.toolkit;
    const renderer = makeRenderer();
    renderer.shadowMap.enabled = true;
    const sphere = new THREE.SphereGeometry(0.9, 512, 256);
    const mesh = new THREE.Mesh(sphere, new THREE.MeshStandardMaterial());
    const hatched = await applyHatching(mesh, { detail: { simplifier } });
    const scene = sceneOf(sun(), mesh);
    const [near, far] = [1.2, 20].map((z) => {
      const camera = makeCamera();
      camera.position.z = z;
      return camera;
    });
    const drawn = (camera: Camera): number => {
      pixelsOf(scene, renderer, camera);
      return renderer.info.render.triangles;
    };
    const counts: Record<string, number> = { whole: 0, near: drawn(near), far: drawn(far), nearAgain: drawn(near) };
    counts.whole = sphere.index!.count / 3;
    // An orthographic view from afar shows it as large as a perspective one from nearby.
    const flat = new THREE.OrthographicCamera(-0.01, 0.01, 0.01, -0.01, 0.1, 100);
    flat.position.z = 20;
    counts.magnified = drawn(flat);
    // A tile of a large picture.
    const tile = makeCamera();
    tile.position.z = 20;
    tile.setViewOffset(96 * 400, 96 * 400, 96 * 200, 96 * 200, 96, 96);
    counts.tile = drawn(tile);
    const light = sun();
    light.castShadow = true;
    mesh.castShadow = true;
    scene.add(light);
    drawn(far);
    counts.withShadow = drawn(far);
    scene.remove(light);
    const clone = mesh.clone();
    clone.position.x = 100;
    clone.frustumCulled = false;
    scene.add(clone);
    counts.withClone = drawn(far);
    const hits = new THREE.Raycaster(new THREE.Vector3(0.1, 0.1, 5), new THREE.Vector3(0, 0, -1))
      .intersectObject(mesh)
      .map(({ distance }) => distance);
    hatched.dispose();
    return { counts, hits };
  }, SIMPLIFIER);
  const { whole, near, far, nearAgain, magnified, tile, withShadow, withClone } = counts;
  expect(near).toBeGreaterThan(5 * far);
  expect(nearAgain).toBe(near);
  expect(magnified).toBe(whole);
  expect(tile).toBe(whole);
  expect(withShadow).toBe(2 * far);
  expect(withClone).toBe(far + whole);
  expect(hits[0]).toBeCloseTo(5 - Math.sqrt(0.81 - 0.02), 3);
});

test('without the simplifier a sentence says so, and the mesh is drawn whole', { tag: '@all' }, async ({
  page,
  pageProblems,
}) => {
  const { pixels, triangles } = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, applyHatching, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    HatchingMaterial.silent = false;
    const mesh = new THREE.Mesh(new THREE.SphereGeometry(0.9, 512, 256), new THREE.MeshStandardMaterial());
    const hatched = await applyHatching(mesh, { detail: { simplifier: '/nowhere/meshopt_simplifier.js' } });
    const renderer = makeRenderer();
    const pixels = pixelsOf(sceneOf(sun(), mesh), renderer);
    const { triangles } = renderer.info.render;
    hatched.dispose();
    HatchingMaterial.silent = true;
    return { pixels, triangles };
  });
  expect(triangles).toBe(512 * 255 * 2);
  expect(pixels.some((_, i) => i % 4 === 0 && !isGround(pixels.slice(i, i + 3)))).toBe(true);
  expect(pageProblems.splice(0)).toEqual([
    expect.stringMatching(
      /applyHatching: meshes are drawn without levels of detail\. meshoptimizer could not be loaded from /,
    ),
  ]);
});
