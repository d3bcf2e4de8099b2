import { expect } from '../browser/test.js';
import { differing } from './pixels.js';
import { test } from './toolkitPage.js';

/** A distance at which single precision has no numbers between two integers. */
const FAR = 2 ** 23;

test('a scene far from the origin of the world is drawn as it is there', async ({ page }) => {
  const [near, far, empty] = await page.evaluate(async (distance) => {
    const { THREE, applyHatching, sun, pixelsOf, makeRenderer } = window.toolkit;
    const drawnAt = async (x: number): Promise<number[]> => {
      const material = new THREE.MeshStandardMaterial();
      const ball = new THREE.Mesh(new THREE.SphereGeometry(0.6, 24, 16), material);
      const box = new THREE.Mesh(new THREE.BoxGeometry(0.5, 0.5, 0.5), material);
      const floor = new THREE.Mesh(new THREE.PlaneGeometry(3, 3), material);
      box.position.set(0.9, -0.2, 0.6);
      floor.rotation.x = -Math.PI / 2;
      floor.position.y = -0.6;
      const light = sun();
      const root = new THREE.Group().add(ball, box, floor, light, light.target);
      root.position.set(x, x / 2, -x);
      const scene = new THREE.Scene().add(root);
      await applyHatching(root, { outlines: true, material: { technique: 'engraving', lineSpacing: 5 } });
      const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 50);
      camera.position.set(x + 2, x / 2 + 2, -x + 5);
      camera.lookAt(root.position);
      return pixelsOf(scene, makeRenderer(), camera);
    };
    const white = pixelsOf(new THREE.Scene(), makeRenderer(), new THREE.PerspectiveCamera());
    return [await drawnAt(0), await drawnAt(distance), white];
  }, FAR);
  expect(differing(near, empty, 40)).toBeGreaterThan(500);
  expect(differing(near, far, 40)).toBeLessThan(10);
});

for (const preset of ['pencil', 'woodcut'] as const) {
  const title = `objects at ten million units are drawn as at the origin, with exposure, hollows and background: ${preset}`;
  test(title, { tag: '@all' }, async ({ page }) => {
    const [near, far, empty] = await page.evaluate(async (name) => {
      const { THREE, applyHatching, bakeOcclusion, HatchingBackground, sun, pixelsOf, makeRenderer } = window.toolkit;
      const drawnAt = async (x: number): Promise<number[]> => {
        const material = new THREE.MeshStandardMaterial({ color: 'tan' });
        const ball = new THREE.Mesh(new THREE.SphereGeometry(0.6, 24, 16), material);
        const floor = new THREE.Mesh(new THREE.PlaneGeometry(3, 3, 8, 8), material);
        floor.rotation.x = -Math.PI / 2;
        floor.position.y = -0.6;
        const light = sun();
        // Each object has its own far position; no group is moved.
        const scene = new THREE.Scene().add(ball, floor, light, light.target);
        for (const object of [ball, floor, light, light.target])
          object.position.add(new THREE.Vector3(x, -x / 4, x / 2));
        scene.updateMatrixWorld();
        const { materials } = await applyHatching(scene, { preset: name, outlines: true });
        await bakeOcclusion(scene);
        await Promise.all(materials.map(({ ready }) => ready));
        scene.add(new HatchingBackground(scene, { tone: 0.3 }));
        const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 50);
        camera.position.set(x + 2, -x / 4 + 2, x / 2 + 5);
        camera.lookAt(ball.position);
        return pixelsOf(scene, makeRenderer(), camera);
      };
      const white = pixelsOf(new THREE.Scene(), makeRenderer(), new THREE.PerspectiveCamera());
      return [await drawnAt(0), await drawnAt(1e7), white];
    }, preset);
    expect(differing(near, empty, 40)).toBeGreaterThan(500);
    expect(differing(near, far, 40)).toBeLessThan(25);
  });
}
