import { expect } from '../browser/test.js';
import { at, difference, differing } from './pixels.js';
import { test } from './toolkitPage.js';

/** One handle through all that a configurator does: colours, hiding, fading, swapping parts, switching looks, and freeing all. */

test('a source that changes shows in the next frame: colour, visibility there and back, opacity', async ({ page }) => {
  const shots = await page.evaluate(async () => {
    const { THREE, applyHatching, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const part = (x: number, color: string, z = 0) => {
      const source = new THREE.MeshStandardMaterial({ color });
      const mesh = new THREE.Mesh(new THREE.PlaneGeometry(0.9, 1.2), source);
      mesh.position.set(x, 0, z);
      return { mesh, source };
    };
    const [left, right, behind] = [part(-0.6, 'white'), part(0.6, 'white'), part(0.6, 'red', -0.2)];
    const root = new THREE.Group().add(behind.mesh, right.mesh, left.mesh);
    const scene = sceneOf(root, sun(Math.PI, [0, 0, 1]));
    await applyHatching(root, { tonalArtMap: null });
    const shoot = (change: () => void) => {
      change();
      return pixelsOf(scene, renderer);
    };
    return {
      first: shoot(() => {}),
      blue: shoot(() => left.source.color.set('blue')),
      hidden: shoot(() => Object.assign(right.source, { visible: false })),
      shown: shoot(() => Object.assign(right.source, { visible: true })),
      faded: shoot(() => Object.assign(right.source, { transparent: true, opacity: 0.5 })),
      opaque: shoot(() => Object.assign(right.source, { transparent: false, opacity: 1 })),
    };
  });
  const [left, right] = (['first', 'blue', 'hidden', 'shown', 'faded', 'opaque'] as const).reduce<number[][][]>(
    ([ofLeft, ofRight], name) => [
      [...ofLeft, at(shots[name], 30, 48)],
      [...ofRight, at(shots[name], 66, 48)],
    ],
    [[], []],
  );
  const [white, red, blue] = [
    [255, 255, 255],
    [255, 0, 0],
    [0, 0, 255],
  ];
  expect(left).toEqual([white, blue, blue, blue, blue, blue]);
  expect(right).toEqual([white, white, red, white, [255, 128, 128], white]);
});

test('a part fades alone, with its outlines, and a picture of another look comes with the same handle', async ({
  page,
}) => {
  const { before, faded, restored, alone, switched, again, messages } = await page.evaluate(async () => {
    const { THREE, applyHatching, greyMap, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const part = (x: number) => {
      const mesh = new THREE.Mesh(new THREE.BoxGeometry(0.7, 0.7, 0.7), new THREE.MeshStandardMaterial());
      mesh.position.x = x;
      mesh.rotation.set(0.5, 0.6, 0);
      return mesh;
    };
    const [left, right] = [part(-0.7), part(0.7)];
    const root = new THREE.Group().add(left, right);
    const scene = sceneOf(root, sun());
    const look = { tonalArtMap: greyMap(), outlines: { outlineWidth: 3, creaseLength: 0 } };
    const hatched = await applyHatching(root, look);
    const before = pixelsOf(scene, renderer);
    const fade = (opacity: number) =>
      right.traverse((object) => {
        const { material } = object as typeof right;
        if (material) Object.assign(material, { opacity, transparent: opacity < 1 });
      });
    fade(0.25);
    const faded = pixelsOf(scene, renderer);
    fade(1);
    const restored = pixelsOf(scene, renderer);
    right.visible = false;
    const alone = pixelsOf(scene, renderer);
    right.visible = true;

    const stop = new AbortController();
    const late = hatched.setPreset('engraving', { signal: stop.signal });
    stop.abort();
    const messages = [await late.catch(({ name }) => name)];
    const earlier = hatched.setPreset('engraving');
    await hatched.setPreset('technical');
    messages.push(await earlier.catch(({ name }) => name));
    const switched = pixelsOf(scene, renderer);
    await hatched.setPreset(look);
    const again = pixelsOf(scene, renderer);
    return { before, faded, restored, alone, switched, again, messages };
  });
  expect(messages).toEqual(['AbortError', 'AbortError']);
  expect(difference(before, restored)).toBe(0);
  expect(differing(before, switched, 8)).toBeGreaterThan(300);
  expect(difference(before, again), 'the former look again').toBe(0);
  // The left part is the same while the right one fades.
  const half = (pixels: number[]) => pixels.filter((_, i) => (i >> 2) % 96 < 48);
  expect(difference(half(before), half(faded))).toBe(0);
  // Lines and surface fade by one share: what is left of each pixel's difference to the bare ground.
  const of = (pixels: number[], at: number) => ((at >> 2) % 96 >= 48 ? pixels[at] - alone[at] : 0);
  let [kept, whole] = [0, 0];
  for (let i = 0; i < before.length; i++) {
    kept += Math.abs(of(faded, i));
    whole += Math.abs(of(before, i));
  }
  expect(kept / whole).toBeCloseTo(0.25, 1);
});

test('a hundred swaps and a switch of looks leave nothing on the graphics card', async ({ page }) => {
  const { start, first, last, end } = await page.evaluate(async () => {
    const { THREE, applyHatching, sceneOf, sun, makeCamera, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const camera = makeCamera();
    const make = () => new THREE.Mesh(new THREE.TorusGeometry(0.4, 0.2, 8, 12), new THREE.MeshStandardMaterial());
    const root = new THREE.Group().add(make());
    const scene = sceneOf(root, sun());
    const use = () => {
      renderer.render(scene, camera);
      return { ...renderer.info.memory, programs: renderer.info.programs!.length };
    };
    scene.remove(root);
    const start = use();
    scene.add(root);
    const hatched = await applyHatching(root, 'technical');
    const swap = async () => {
      const part = make();
      root.add(part);
      await hatched.update();
      const during = use();
      root.remove(part);
      hatched.release(part);
      part.geometry.dispose();
      part.material.dispose();
      return during;
    };
    const first = await swap();
    for (let i = 0; i < 98; i++) await swap();
    await hatched.setPreset('engraving');
    use();
    await hatched.setPreset('technical');
    const last = await swap();
    hatched.dispose();
    scene.remove(root);
    return { start, first, last, end: use() };
  });
  expect([last.geometries, last.textures]).toEqual([first.geometries, first.textures]);
  expect(end.geometries).toBe(start.geometries);
  expect(end.programs).toBe(start.programs);
  // What all materials share, such as the blank texel, may stay.
  expect(end.textures - start.textures).toBeLessThanOrEqual(1);
});
