import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

/** Dots, measured on a wall that fills the picture, in tones that light from all around makes. */

/** The ink of one dot that touches no border. */
interface Dot {
  x: number;
  y: number;
  area: number;
  /** Ratio of the longer axis of its ellipse to the shorter. */
  aspect: number;
}

/** The page's functions for these tests. */
interface Stage {
  /** Darkness of every pixel, 0 to 1, row by row from below. */
  draw(change?: {
    tone?: number;
    slant?: number;
    wall?: number;
    x?: number;
    zoom?: number;
    dot?: number;
  }): Float32Array;
  dotsOf(darkness: Float32Array): Dot[];
}

const SIDE = 256;
/** The same wall, but it lies in each object in another way. */
const WALLS = [0, 1, 2, 3, 4];

test.beforeEach(async ({ page }) => {
  await page.evaluate(
    async ([side, ways]) => {
      const { THREE, hatchedMesh, makeRenderer, sceneOf, wholePieces } = window.toolkit;
      const walls = await Promise.all(
        ways.map(async (n) => {
          const turned = new THREE.Quaternion().setFromEuler(new THREE.Euler(0.9 * n, 2.3 * n, 1.7 * n));
          const mesh = await hatchedMesh(new THREE.PlaneGeometry(200, 200).applyQuaternion(turned), {
            technique: 'stipple',
            tonalArtMap: null,
            screenSpaceShare: 1,
          });
          return { mesh, upright: turned.invert() };
        }),
      );
      const light = new THREE.AmbientLight();
      const scene = sceneOf(...walls.map(({ mesh }) => mesh), light);
      const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 600);
      camera.position.z = 300;
      const renderer = makeRenderer();
      renderer.setSize(side, side, false);
      const gl = renderer.getContext();
      const pixels = new Uint8Array(4 * side * side);
      const sideways = new THREE.Vector3(1, 0, 0);
      const draw: Stage['draw'] = ({ tone = 0.2, slant = 0, wall = 0, x = 0, zoom = 1, dot = 16 } = {}) => {
        for (const [n, { mesh, upright }] of walls.entries()) {
          mesh.visible = n === wall;
          mesh.material.strokeWidth = dot;
          mesh.quaternion.setFromAxisAngle(sideways, (-slant * Math.PI) / 180).multiply(upright);
        }
        light.intensity = Math.PI * (1 - tone);
        camera.position.x = x;
        camera.zoom = zoom;
        camera.updateProjectionMatrix();
        renderer.render(scene, camera);
        gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        return Float32Array.from({ length: side * side }, (_, i) => 1 - pixels[4 * i] / 255);
      };
      const dotsOf: Stage['dotsOf'] = (darkness) => {
        const dots: Dot[] = [];
        for (const piece of wholePieces(side, (i) => darkness[i] >= 0.4)) {
          let [area, sx, sy, xx, xy, yy] = [0, 0, 0, 0, 0, 0];
          for (const i of piece) {
            const [px, py] = [i % side, Math.floor(i / side)];
            const w = darkness[i];
            area += w;
            sx += w * px;
            sy += w * py;
            xx += w * px * px;
            xy += w * px * py;
            yy += w * py * py;
          }
          if (area < 4) continue;
          const [x, y] = [sx / area, sy / area];
          const [vxx, vxy, vyy] = [xx / area - x * x, xy / area - x * y, yy / area - y * y];
          const half = Math.hypot((vxx - vyy) / 2, vxy);
          const mean = (vxx + vyy) / 2;
          dots.push({ x, y, area, aspect: Math.sqrt((mean + half) / Math.max(mean - half, 1e-6)) });
        }
        return dots;
      };
      Object.assign(window, { stage: { draw, dotsOf } });
    },
    [SIDE, WALLS] as const,
  );
});

declare global {
  interface Window {
    stage: Stage;
  }
}

const middle = (values: readonly number[], share = 0.5): number =>
  values.toSorted((a, b) => a - b)[Math.floor(share * values.length)];

/** The mean distance to the nearest other dot, to that of the densest lattice of as many. */
function evenness(dots: readonly Dot[]): number {
  const margin = 30;
  const inner = dots.filter(({ x, y }) => Math.min(x, y, SIDE - x, SIDE - y) > margin);
  const nearest = inner.map((one) =>
    Math.min(...dots.map((other) => (other === one ? Infinity : Math.hypot(one.x - other.x, one.y - other.y)))),
  );
  const room = (SIDE - 2 * margin) ** 2 / inner.length;
  return nearest.reduce((sum, away) => sum + away, 0) / inner.length / Math.sqrt((2 / Math.sqrt(3)) * room);
}

test(
  'dots are round and even at any slant, and do not merge below half tone',
  { tag: '@all' },
  async ({ page }, testInfo) => {
    const found = await page.evaluate((walls) => {
      const { draw, dotsOf } = window.stage;
      return [0, 45, 60, 70].map((slant) => ({
        slant,
        // Two scales between octaves, and walls in five orientations in the object.
        light: walls.flatMap((wall) =>
          [1.5, 1.95].map((zoom) => dotsOf(draw({ tone: 0.12, slant, wall, dot: 12, zoom }))),
        ),
        mid: walls.flatMap((wall) => dotsOf(draw({ tone: 0.35, slant, wall, dot: 10 }))),
      }));
    }, WALLS);
    for (const { slant, light, mid } of found) {
      const aspects = light.flat().map(({ aspect }) => aspect);
      const even = light.map(evenness);
      // Areas much larger than most are several dots that touch.
      const most = middle(mid.map(({ area }) => area));
      const merged = mid.filter(({ area }) => area > 1.7 * most).length / mid.length;
      testInfo.annotations.push({
        type: `${slant}°`,
        description: `${aspects.length} dots, aspect ${middle(aspects).toFixed(2)}, nine in ten below ${middle(aspects, 0.9).toFixed(2)}; evenness ${even.map((value) => value.toFixed(2))}; merged ${merged.toFixed(2)} of ${mid.length}`,
      });
      expect(aspects.length).toBeGreaterThan(100);
      expect(middle(aspects), `aspect at ${slant}°`).toBeLessThan(1.1);
      expect(middle(aspects, 0.9), `aspect at ${slant}°`).toBeLessThan(1.3);
      // The set is less even while dots appear, and foreshortened at a slant. Random dots would have 0.47.
      for (const value of even)
        expect(value, `evenness at ${slant}°`).toBeGreaterThan({ 0: 0.75, 45: 0.7, 60: 0.65, 70: 0.6 }[slant]!);
      expect(merged, `merged at ${slant}°`).toBeLessThan(slant < 70 ? 0.08 : 0.25);
    }
  },
);

test(
  'the ink of dots is the tone in the mean, and in the darks more, at any size and slant and between octaves',
  { tag: '@all' },
  async ({ page }, testInfo) => {
    const errors = await page.evaluate(() => {
      const { draw } = window.stage;
      const found: string[] = [];
      for (const [slant, dot] of [
        [0, 2],
        [0, 3.2],
        [0, 8],
        [30, 3.2],
        [60, 3.2],
      ]) {
        for (const tone of [0.02, 0.1, 0.3, 0.5, 0.55, 0.6, 0.7, 0.8]) {
          const cover = tone + 0.05 * (Math.max(tone - 0.7, 0) / 0.25) ** 2;
          // A tone needs several pictures, because there are few dots in the lights.
          for (const zoom of [1, 1.25, 1.55]) {
            const mean = draw({ tone, slant, dot, zoom }).reduce((sum, ink) => sum + ink, 0) / 256 ** 2;
            found.push(`${slant}° ${dot} px ${tone} ${zoom}: ${(mean - cover).toFixed(3)}`);
          }
        }
      }
      return found;
    });
    const size = (error: string): number => Math.abs(Number(error.split(': ')[1]));
    const sorted = errors.toSorted((a, b) => size(b) - size(a));
    testInfo.annotations.push({ type: 'tone error', description: sorted.slice(0, 8).join('; ') });
    // The soft edges of the smallest dots close a little earlier.
    for (const error of sorted) expect(size(error), error).toBeLessThan(/px 0.[78]/.test(error) ? 0.08 : 0.02);
  },
);

test('dots crowd and shrink as the tone deepens, and from 0.95 on leave no paper', {
  tag: '@all',
}, async ({ page }) => {
  const found = await page.evaluate((walls) => {
    const { draw, dotsOf } = window.stage;
    const lights = [0.04, 0.08, 0.13, 0.2, 0.28, 0.36].map((tone) => {
      const dots = walls.flatMap((wall) => [1, 1.3].flatMap((zoom) => dotsOf(draw({ tone, wall, zoom, dot: 9 }))));
      const areas = dots.map(({ area }) => area).sort((a, b) => a - b);
      // Appearing dots are smaller, and some dots have merged.
      return { count: dots.length, area: areas[Math.floor(0.75 * areas.length)] };
    });
    // The pieces of paper that are left.
    const paper = [0.74, 0.78, 0.82, 0.86].map((tone) => {
      const specks = walls.flatMap((wall) => dotsOf(draw({ tone, wall, dot: 9 }).map((ink) => 1 - ink)));
      return specks.reduce((sum, { area }) => sum + area, 0) / specks.length;
    });
    const blank = [0.95, 0.97, 1].flatMap((tone) => [0, 70].map((slant) => draw({ tone, slant, dot: 9 })));
    return { lights, paper, lightest: Math.min(...blank.map((ink) => Math.min(...ink))) };
  }, WALLS);
  for (const [i, { count }] of found.lights.entries()) {
    if (i > 0) expect(count, JSON.stringify(found.lights)).toBeGreaterThan(1.1 * found.lights[i - 1].count);
  }
  // Dots of the lights have one size, except for appearing and merged ones.
  const areas = found.lights.map(({ area }) => area);
  expect(Math.max(...areas) / Math.min(...areas), JSON.stringify(found.lights)).toBeLessThan(1.3);
  for (const [i, area] of found.paper.entries()) {
    if (i > 0) expect(area, `${found.paper}`).toBeLessThan(found.paper[i - 1]);
  }
  expect(found.lightest).toBeGreaterThan(0.99);
});

test('dots stay where they are on the surface, while others are born and die', async ({ page }) => {
  const found = await page.evaluate(() => {
    const { draw, dotsOf } = window.stage;
    const look = { tone: 0.12, dot: 9 };
    const before = dotsOf(draw(look));
    /** The share of dots that are found where they should be, of those that should be well within the picture. */
    const kept = (after: ReturnType<typeof dotsOf>, to: (x: number, y: number) => [number, number]): number => {
      const wanted = before.map(({ x, y }) => to(x, y)).filter(([x, y]) => Math.min(x, y, 256 - x, 256 - y) > 25);
      const isThere = wanted.filter(([x, y]) => after.some((other) => Math.hypot(other.x - x, other.y - y) < 1));
      return wanted.length < 8 ? 0 : isThere.length / wanted.length;
    };
    // 256 pixels are two units wide.
    const shifted = kept(dotsOf(draw({ ...look, x: 10.3 / 128 })), (x, y) => [x - 10.3, y]);
    const nearer = [1.05, 1.4, 2, 2.9].map((zoom) =>
      kept(dotsOf(draw({ ...look, zoom })), (x, y) => [127.5 + zoom * (x - 127.5), 127.5 + zoom * (y - 127.5)]),
    );
    // Dots appear gradually: after a small step of the camera little ink is elsewhere than the motion takes it.
    const slanted = kept(dotsOf(draw({ ...look, slant: 12 })), (x, y) => [
      x,
      127.5 + Math.cos((12 * Math.PI) / 180) * (y - 127.5),
    ]);
    const ink = [1, 1.004].map((zoom) => draw({ ...look, zoom }));
    let changed = 0;
    ink[0].forEach((value, i) => {
      const [x, y] = [(i % 256) - 127.5, Math.floor(i / 256) - 127.5];
      if (Math.max(Math.abs(x), Math.abs(y)) < 20 && Math.abs(value - ink[1][i]) > 0.5) changed++;
    });
    return { count: before.length, shifted, nearer, slanted, changed };
  });
  expect(found.count).toBeGreaterThan(60);
  expect(found.shifted).toBeGreaterThan(0.97);
  // Dots stay while the camera approaches, whatever the distance at which they appeared.
  for (const share of found.nearer) expect(share, `${found.nearer}`).toBeGreaterThan(0.9);
  expect(found.slanted).toBeGreaterThan(0.9);
  expect(found.changed).toBeLessThan(5);
});

test('tiles of a larger picture have the dots of the whole; dots follow a bone; any lights, layers and shadows draw them', {
  tag: '@all',
}, async ({ page }) => {
  const found = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, makeRenderer, sceneOf } = window.toolkit;
    const side = 128;
    const material = new HatchingMaterial({
      technique: 'stipple',
      screenSpaceShare: 1,
      strokeWidth: 6,
    });
    const geometry = new THREE.SphereGeometry(1.2, 48, 32);
    const count = geometry.attributes.position.count;
    geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(new Uint16Array(4 * count), 4));
    geometry.setAttribute(
      'skinWeight',
      new THREE.Float32BufferAttribute(
        Float32Array.from({ length: 4 * count }, (_, i) => Number(i % 4 === 0)),
        4,
      ),
    );
    const mesh = new THREE.SkinnedMesh(geometry, material);
    const bone = new THREE.Bone();
    mesh.add(bone);
    mesh.bind(new THREE.Skeleton([bone]));
    mesh.castShadow = mesh.receiveShadow = true;
    const lights = [new THREE.DirectionalLight('white', Math.PI), new THREE.PointLight('white', 4)];
    lights[0].position.set(1, 2, 2);
    lights[1].position.set(-2, 0, 2);
    lights[0].castShadow = true;
    const scene = sceneOf(mesh, lights[0]);
    scene.background = new THREE.Color('white');
    const camera = new THREE.OrthographicCamera(-2, 2, 2, -2, 0.1, 20);
    camera.position.z = 5;
    const renderer = makeRenderer();
    renderer.shadowMap.enabled = true;
    const gl = renderer.getContext();
    const drawn = (width: number, height: number): Uint8Array => {
      renderer.setSize(width, height, false);
      renderer.render(scene, camera);
      const pixels = new Uint8Array(4 * width * height);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return pixels;
    };
    const whole = drawn(side, side);
    let seams = 0;
    for (const [x, y] of [
      [0, 0],
      [0.5, 0],
      [0, 0.5],
      [0.5, 0.5],
    ]) {
      camera.setViewOffset(side, side, x * side, y * side, side / 2, side / 2);
      const tile = drawn(side / 2, side / 2);
      for (let row = 0; row < side / 2; row++) {
        // Rows count from below.
        const start = 4 * ((row + (0.5 - y) * side) * side + x * side);
        whole.subarray(start, start + 2 * side).forEach((value, i) => {
          seams += Number(Math.abs(value - tile[2 * side * row + i]) > 8) / whole.length;
        });
      }
    }
    camera.clearViewOffset();
    // A shift of eight pixels to the right.
    bone.position.x = 0.25;
    const moved = drawn(side, side);
    bone.position.x = 0;
    let left = 0;
    for (let i = 0; i < moved.length - 32; i += 4) {
      if ((i / 4) % side < side - 8) left += Number(Math.abs(moved[i + 32] - whole[i]) > 8) / (side * side);
    }
    const ink = (pixels: Uint8Array): number =>
      pixels.reduce((sum, value) => sum + 1 - value / 255, 0) / (3 * side * side);
    const inks = [ink(whole)];
    scene.add(lights[1]);
    for (const strokeLayers of ['single', 'lights', 'tone'] as const) {
      for (const shadowStrokes of ['tone', 'cross', 'reorient'] as const) {
        Object.assign(material, { strokeLayers, shadowStrokes });
        inks.push(ink(drawn(side, side)));
      }
    }
    return { seams, left, inks };
  });
  expect(found.seams).toBeLessThan(0.002);
  expect(found.left).toBeLessThan(0.01);
  expect(found.inks[0]).toBeGreaterThan(0.05);
  // A second light leaves less ink, and however it is laid, the tone is the same.
  for (const ink of found.inks.slice(1)) {
    expect(ink, `${found.inks}`).toBeLessThan(found.inks[0]);
    expect(Math.abs(ink - found.inks[1]), `${found.inks}`).toBeLessThan(0.02);
  }
});
