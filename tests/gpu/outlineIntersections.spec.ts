import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Lines along which the surfaces of parts cut each other, on the canvas. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

test('two balls have a line where they meet, while they rest and move together, and none while one moves', async ({
  page,
}) => {
  const shares = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, pixelOf, inkNear } = window.lining;
    const camera = lookFrom(1.2, 1.3, 2.4);
    const ball = () => new THREE.SphereGeometry(0.5, 96, 48).rotateZ(0.3);
    const [one, other] = [0, 1].map(() => ({ intersections: true, outlineWidth: 2, weights: { intersections: 1 } }));
    const [left, right] = [await outlinedMesh(ball(), one), await outlinedMesh(ball(), other)];
    left.position.x = -0.3;
    right.position.x = 0.3;
    const both = new THREE.Group().add(left, right);
    const scene = paperScene(both);
    const found = () => new Promise((resolve) => scene.addEventListener('intersections' as never, resolve));
    /** The share of the visible part of the circle that has ink within a pixel and a half. */
    const share = (): number => {
      const ink = draw(scene, camera);
      const places = Array.from({ length: 90 }, (_, i) => {
        const angle = (i / 90) * 2 * Math.PI;
        const place = new THREE.Vector3(0, 0.4 * Math.cos(angle), 0.4 * Math.sin(angle));
        const sight = both.worldToLocal(camera.position.clone()).sub(place).normalize();
        const facing = [-0.3, 0.3].map((x) => place.clone().setX(-x).normalize().dot(sight));
        return { at: pixelOf(both.localToWorld(place), camera, 400), facing: Math.min(...facing) };
      }).filter(({ facing }) => facing > 0.1);
      return places.filter(({ at }) => inkNear(ink, 400, at, 1.5) > 0.5).length / places.length;
    };
    const first = found();
    const before = share();
    await first;
    const resting = share();
    both.rotation.y = 0.4;
    const together = share();
    right.rotation.y = 0.1;
    right.position.x = 0.31;
    const apart = share();
    right.position.x = 0.3;
    const again = found();
    share();
    await again;
    const back = share();
    right.visible = false;
    const alone = share();
    return { before, resting, together, apart, back, alone };
  });
  const { apart, alone, ...others } = shares;
  expect(others).toEqual({ before: 0, resting: 1, together: 1, back: 1 });
  // The ends of the line lie on the contours of the balls.
  expect(Math.max(apart, alone)).toBeLessThan(0.15);
});
