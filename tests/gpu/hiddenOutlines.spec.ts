import { quickIf } from '../browser/quickIf.js';
import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Outlines that a surface hides, counted against rays: stacks of thin plates with bolts through them, as instances. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

const STACKS = {
  'plates and round bolts': { plate: 'box', bolt: 'round', eye: [2.4, 2, 3] },
  'discs and hexagonal bolts, from low': { plate: 'disc', bolt: 'hexagonal', eye: [1.5, 0.9, 3.6] },
  'plates with holes and round bolts, from above': { plate: 'drilled', bolt: 'round', eye: [-1.2, 3.6, 2] },
} as const;

for (const [name, stack] of Object.entries(STACKS)) {
  test(
    `no outline shows through three stacked ${name}`,
    quickIf(name === 'discs and hexagonal bolts, from low'),
    async ({ page }) => {
      const { length, missing, stray } = await page.evaluate(async ({ plate, bolt, eye }) => {
        const { THREE, outlinedInstances, paperScene, lookFrom, draw, rendererOf, visibleLines, wrongLength } =
          window.lining;
        const size = 600;
        const corners = [-0.7, 0.7].flatMap((x) => [-0.5, 0.5].map((z) => [x, z] as const));
        const drilled = () => {
          const shape = new THREE.Shape(
            [
              [-1, -0.8],
              [1, -0.8],
              [1, 0.8],
              [-1, 0.8],
            ].map(([x, y]) => new THREE.Vector2(x, y)),
          );
          for (const [x, z] of corners) shape.holes.push(new THREE.Path().absarc(x, z, 0.13, 0, 2 * Math.PI, true));
          return new THREE.ExtrudeGeometry(shape, { depth: 0.03, bevelEnabled: false, curveSegments: 24 })
            .rotateX(Math.PI / 2)
            .translate(0, 0.015, 0);
        };
        const plates = {
          box: () => new THREE.BoxGeometry(2, 0.03, 1.6),
          disc: () => new THREE.CylinderGeometry(1, 1, 0.03, 64),
          drilled,
        };
        const bolts = {
          round: () => new THREE.CylinderGeometry(0.1, 0.1, 1.3, 32),
          hexagonal: () => new THREE.CylinderGeometry(0.1, 0.1, 1.3, 6),
        };
        const options = { weights: { creases: 1, innerContours: 1 }, lostEdges: 0, accents: 0 };
        const stacked = await outlinedInstances(
          plates[plate](),
          [-0.25, 0, 0.25].map((y) => new THREE.Matrix4().setPosition(0, y, 0)),
          options,
        );
        const through = await outlinedInstances(
          bolts[bolt](),
          corners.map(([x, z]) => new THREE.Matrix4().setPosition(x, 0, z)),
          options,
        );
        const camera = lookFrom(eye[0], eye[1], eye[2]);
        const renderer = rendererOf(size);
        const ink = draw(paperScene(stacked, through), camera, renderer);
        const seen = visibleLines([stacked, through], camera, size);
        return wrongLength(ink, seen, size, 1.8);
      }, stack);
      expect(length).toBeGreaterThan(3000);
      expect(missing + stray).toBeLessThan(0.002 * length);
    },
  );
}
