import { expect } from '../browser/test.js';
import { differing } from './pixels.js';
import { test } from './toolkitPage.js';

/** Where single precision has no room for what lies between two whole numbers. */
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
      await applyHatching(root, { outlines: true, material: { technique: 'engraved', lineSpacing: 5 } });
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
