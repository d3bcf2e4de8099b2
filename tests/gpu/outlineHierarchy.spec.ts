import { quickIf } from '../browser/quickIf.js';
import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Line weight: before paper and before a surface, in light and in shade, and where an outline passes before another. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

for (const lostEdges of [0, 0.2, 0.6, 1]) {
  test(
    `the contour of a sphere is as wide as its angle to the light asks, thin where it is lost; ${lostEdges} of its edges are`,
    quickIf(lostEdges === 0.2),
    async ({ page }) => {
      const { widths, expected } = await page.evaluate(async (lostEdges) => {
        const { THREE, outlinedMesh, paperScene, lookFrom, draw, rendererOf, pixelOf } = window.lining;
        const size = 700;
        const mesh = await outlinedMesh(new THREE.IcosahedronGeometry(1, 60), {
          outlineWidth: 5,
          weights: { lit: 0.6, shade: 1.7 },
          lostEdges,
        });
        const light = new THREE.DirectionalLight(0xffffff, 3);
        light.position.set(-2, 1, 1.2);
        const camera = lookFrom(0, 0, 4.2);
        const ink = draw(paperScene(mesh, light), camera, rendererOf(size));

        const eye = camera.position;
        const towardsLight = light.position.clone().normalize();
        const smoothstep = (from: number, to: number, x: number) => THREE.MathUtils.smoothstep(x, from, to);
        // The normals of the contour enclose a right angle with the direction to the eye.
        const rise = 1 / eye.z;
        const radius = pixelOf(new THREE.Vector3(Math.sqrt(1 - rise ** 2), 0, rise), camera, size).x - size / 2;
        const bins = 60;
        const widths = new Array<number>(bins).fill(0);
        ink.forEach((darkness, i) => {
          const angle = Math.atan2(size / 2 - Math.floor(i / size) - 0.5, (i % size) + 0.5 - size / 2);
          widths[Math.floor((angle / (2 * Math.PI) + 0.5) * (bins - 1e-6))] += darkness;
        });
        const expected = widths.map((_, bin) => {
          const angle = ((bin + 0.5) / bins - 0.5) * 2 * Math.PI;
          const across = Math.sqrt(1 - rise ** 2);
          const normal = new THREE.Vector3(across * Math.cos(angle), across * Math.sin(angle), rise);
          const inside = eye.clone().sub(normal).normalize().multiplyScalar(0.5).add(normal).normalize();
          const shaded = smoothstep(0.15, 0.85, 0.5 - 0.5 * normal.dot(towardsLight));
          const from = 1 - 0.7 * lostEdges;
          const lost = smoothstep(from, from + 0.05 + 0.35 * lostEdges, inside.dot(towardsLight));
          return 5 * (0.6 + 1.1 * shaded) * (1 - (0.53 + 0.35 * lostEdges) * lost);
        });
        return { widths: widths.map((one) => one / ((2 * Math.PI * radius) / bins)), expected };
      }, lostEdges);
      widths.forEach((width, i) => {
        // A wide outline loses some of its inner side to the surface that rises there.
        expect(Math.abs(width - expected[i]), `${i}: ${width} for ${expected[i]}`).toBeLessThan(
          0.1 + 0.05 * expected[i],
        );
      });
      // Lost outlines keep a thin line, so that none breaks up.
      if (lostEdges > 0) expect(Math.min(...widths) / (5 * 0.6)).toBeCloseTo(0.47 - 0.35 * lostEdges, 1);
      expect(Math.max(...widths)).toBeGreaterThan(7.5);
    },
  );
}

test('before a surface a contour weighs half, before one far behind as before the paper; a crease weighs a third', async ({
  page,
}) => {
  const { paper, near, far } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, rendererOf, HATCHING_OUTLINE_DEFAULTS } = window.lining;
    const { innerContours, creases } = HATCHING_OUTLINE_DEFAULTS.weights;
    const size = 400;
    // The box stands on its corner, so that its upright edges are a crease in the middle and contours on both sides.
    const mesh = await outlinedMesh(new THREE.BoxGeometry(0.8, 3, 0.8).rotateY(Math.PI / 4), {
      outlineWidth: 4,
      weights: { innerContours, creases },
    });
    const wall = new THREE.Mesh(new THREE.PlaneGeometry(60, 60), new THREE.MeshBasicMaterial());
    const camera = lookFrom(0, 0, 4);
    const widthsBefore = (depth: number) => {
      wall.position.z = -depth;
      wall.visible = depth > 0;
      const ink = draw(paperScene(mesh, wall), camera, rendererOf(size));
      const row = ink.subarray((size / 2) * size, (size / 2 + 1) * size);
      const sum = (from: number, to: number) => row.subarray(from, to).reduce((all, one) => all + one, 0);
      return { contour: sum(0, size / 2 - 20), crease: sum(size / 2 - 20, size / 2 + 20) };
    };
    // The view is 2.9 units high where the box stands.
    return { paper: widthsBefore(0), near: widthsBefore(0.6), far: widthsBefore(4) };
  });
  const isAbout = (width: number, asked: number) => expect(Math.abs(width - asked), `${width}`).toBeLessThan(0.25);
  isAbout(paper.contour, 4);
  isAbout(far.contour, 4);
  isAbout(near.contour, 2);
  for (const { crease } of [paper, near, far]) isAbout(crease, 1.4);
});

test('a contour becomes heavier towards the place where another one ends behind it, and only there', async ({
  page,
}) => {
  const widths = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, rendererOf } = window.lining;
    const size = 400;
    const mesh = await outlinedMesh(new THREE.BoxGeometry(1, 4, 0.2), { outlineWidth: 4, accents: 0.5 });
    // The upper half of what lies behind is nearer.
    const [upper, lower] = [-1, -2.5].map((depth) => {
      const wall = new THREE.Mesh(new THREE.PlaneGeometry(20, 10), new THREE.MeshBasicMaterial());
      wall.position.z = depth;
      return wall;
    });
    upper.position.y = 5;
    const ink = draw(paperScene(mesh, upper, lower), lookFrom(0, 0, 5), rendererOf(size));
    return Array.from({ length: 121 }, (_, i) =>
      ink
        .subarray((size / 2 - 60 + i) * size, (size / 2 - 60 + i) * size + size / 2)
        .reduce((all, one) => all + one, 0),
    );
  });
  const atJunction = Math.max(...widths.slice(56, 65));
  expect(atJunction).toBeGreaterThan(5.2);
  expect(atJunction).toBeLessThan(6.3);
  for (const away of [0, 10, 20, 100, 110, 120]) expect(Math.abs(widths[away] - 4), `${away}`).toBeLessThan(0.25);
  // It grows in steps too small to be visible.
  widths.forEach((width, i) => {
    if (i > 0) expect(Math.abs(width - widths[i - 1])).toBeLessThan(0.75);
  });
});

test('while the light moves no outline pops', { tag: '@all' }, async ({ page }) => {
  const { changes, inks } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, mostDifferent, total, HATCHING_OUTLINE_DEFAULTS } =
      window.lining;
    const { weights, lostEdges, accents } = HATCHING_OUTLINE_DEFAULTS;
    const { innerContours, lit, shade } = weights;
    const mesh = await outlinedMesh(new THREE.TorusKnotGeometry(0.7, 0.25, 240, 40), {
      weights: { innerContours, lit, shade },
      lostEdges,
      accents,
    });
    const light = new THREE.DirectionalLight(0xffffff, 3);
    const scene = paperScene(mesh, light);
    const camera = lookFrom(0.5, 0.8, 4);
    const strip = Array.from({ length: 60 }, (_, i) => {
      const angle = (i * Math.PI) / 180;
      light.position.set(Math.cos(angle), 0.6, Math.sin(angle));
      return draw(scene, camera);
    });
    return { changes: strip.slice(1).map((ink, i) => mostDifferent(ink, strip[i])), inks: strip.map(total) };
  });
  for (const change of changes) expect(change).toBeLessThan(0.25);
  expect(Math.max(...inks) / Math.min(...inks)).toBeGreaterThan(1.02);
});
