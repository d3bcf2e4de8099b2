import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Lines along which the surfaces of parts cut each other, on the canvas. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

test('two balls have a line where they meet, while they rest and move together', async ({ page }) => {
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
    const again = found();
    share();
    await again;
    const back = share();
    right.visible = false;
    const alone = share();
    return { before, resting, together, back, alone };
  });
  const { alone, ...others } = shares;
  expect(others).toEqual({ before: 0, resting: 1, together: 1, back: 1 });
  // The ends of the line lie on the contours of the balls.
  expect(alone).toBeLessThan(0.15);
});

/** A scene of two balls, and what tests of moving lines ask of it, in the page. */
const MOVING = `(async () => {
  const { THREE, outlinedMesh, outlinedInstances, paperScene, lookFrom, draw, pixelOf, inkNear } = window.lining;
  const look = { intersections: true, outlineWidth: 2, weights: { intersections: 1 } };
  const camera = lookFrom(1.2, 1.3, 2.4);
  const ball = () => new THREE.SphereGeometry(0.5, 96, 48).rotateZ(0.3);
  /** Draws, and measures the share of the circle, where balls at two places meet, that has ink. */
  const share = (scene, left, right) => {
    const ink = draw(scene, camera);
    const radius = Math.sqrt(0.25 - ((right - left) / 2) ** 2);
    const places = Array.from({ length: 90 }, (_, i) => {
      const angle = (i / 90) * 2 * Math.PI;
      const place = new THREE.Vector3((left + right) / 2, radius * Math.cos(angle), radius * Math.sin(angle));
      const sight = camera.position.clone().sub(place).normalize();
      const facing = [left, right].map((x) => place.clone().setX(place.x - x).normalize().dot(sight));
      return { at: pixelOf(place, camera, 400), facing: Math.min(...facing) };
    }).filter(({ facing }) => facing > 0.25);
    return places.filter(({ at }) => inkNear(ink, 400, at, 1.5) > 0.4).length / places.length;
  };
  /** Draws until the code of moving lines is there. */
  const untilDrawn = async (drawnShare) => {
    for (let i = 0; i < 600; i++) {
      const found = drawnShare(i);
      if (found > 0.5) return found;
      await new Promise((resolve) => setTimeout(resolve, 30));
    }
    return 0;
  };
  return { THREE, outlinedMesh, outlinedInstances, paperScene, lookFrom, draw, look, camera, ball, share, untilDrawn };
})()`;

test('parts that move have their lines where the screen shows them, none where they were, and the exact ones at rest', async ({
  page,
}) => {
  const shares = await page.evaluate<Record<string, number>>(`${MOVING}.then(async (moving) => {
    const { outlinedMesh, paperScene, look, ball, share, untilDrawn } = moving;
    const [left, right] = [await outlinedMesh(ball(), look), await outlinedMesh(ball(), look)];
    left.position.x = -0.3;
    right.position.x = 0.3;
    const scene = paperScene(left, right);
    const before = await untilDrawn(() => share(scene, -0.3, 0.3));
    const at = (i) => 0.2 - 0.001 * i;
    const moved = await untilDrawn((i) => {
      right.position.x = at(i);
      return share(scene, -0.3, at(i));
    });
    right.position.x = 0.05;
    const there = share(scene, -0.3, 0.05);
    right.position.x = 0.3;
    right.position.y = 0.9;
    const gone = share(scene, -0.3, 0.3);
    right.position.y = 0;
    const found = new Promise((resolve) => scene.addEventListener('intersections', resolve));
    right.position.x = 0.1;
    share(scene, -0.3, 0.1);
    await found;
    const resting = share(scene, -0.3, 0.1);
    return { before, moved, there, gone, resting };
  })`);
  const { gone, ...others } = shares;
  for (const share of Object.values(others)) expect(share).toBeGreaterThan(0.95);
  expect(gone).toBeLessThan(0.1);
});

test('instances have lines where they meet', async ({ page }) => {
  const share = await page.evaluate<number>(`${MOVING}.then(async (moving) => {
    const { THREE, outlinedInstances, paperScene, look, ball, share, untilDrawn } = moving;
    const places = [-0.3, 0.25].map((x) => new THREE.Matrix4().makeTranslation(x, 0, 0));
    const scene = paperScene(await outlinedInstances(ball(), places, look));
    return untilDrawn(() => share(scene, -0.3, 0.25));
  })`);
  expect(share).toBeGreaterThan(0.95);
});

test('panels that nearly touch have no hairs while they move', async ({ page }) => {
  const inks = await page.evaluate<{ flat: number; steep: number }>(`${MOVING}.then(async (moving) => {
    const { THREE, outlinedMesh, paperScene, draw, look, camera, untilDrawn } = moving;
    const panel = () => new THREE.PlaneGeometry(1.6, 1.6, 8, 8);
    const [one, other] = [await outlinedMesh(panel(), look), await outlinedMesh(panel(), look)];
    const scene = paperScene(one, other);
    /** Most ink in the middle of both, where no border is. */
    const inkInside = (angle) => {
      other.rotation.x = angle;
      const ink = draw(scene, camera);
      let most = 0;
      for (let y = 170; y < 230; y++) for (let x = 170; x < 230; x++) most = Math.max(most, ink[400 * y + x]);
      return most;
    };
    const steep = await untilDrawn((i) => inkInside(0.6 + 0.001 * i));
    return { steep, flat: inkInside(0.1) };
  })`);
  expect(inks.steep).toBeGreaterThan(0.5);
  expect(inks.flat).toBeLessThan(0.05);
});

test('a ball that moves into one of glass has a line there, as firm as between solid ones', async ({ page }) => {
  const share = await page.evaluate<Record<string, number>>(`${MOVING}.then(async (moving) => {
    const { outlinedMesh, paperScene, look, ball, share, untilDrawn } = moving;
    const [left, right] = [await outlinedMesh(ball(), look), await outlinedMesh(ball(), look)];
    Object.assign(right.material, { transparent: true, opacity: 0.2, depthWrite: false });
    left.position.x = -0.3;
    right.position.x = 0.3;
    const scene = paperScene(left, right);
    await untilDrawn(() => share(scene, -0.3, 0.3));
    const at = (i) => 0.2 - 0.001 * i;
    const moved = await untilDrawn((i) => {
      right.position.x = at(i);
      return share(scene, -0.3, at(i));
    });
    right.position.x = 0.3;
    right.position.y = 0.9;
    return { moved, gone: share(scene, -0.3, 0.3) };
  })`);
  expect(share.moved).toBeGreaterThan(0.95);
  expect(share.gone).toBeLessThan(0.1);
});
