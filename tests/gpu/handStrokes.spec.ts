import type { Page } from '@playwright/test';
import type { Hand, HandStroke } from '../../src/strokes/hand/Hand.js';
import { learnHand } from '../../src/strokes/hand/learnHand.js';
import { drawSwatches } from '../../src/strokes/hands/drawSwatch.js';
import { exampleHabits } from '../../src/strokes/hands/exampleHabits.js';
import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

/** Strokes of a hand in rows, on a plane of even tone: all that differs is the hand. */

const SIDE = 384;

/** Pixels to a millimetre of the sheet where a material gives no width. */
const SCALE = 6;

const names = Object.keys(exampleHabits) as (keyof typeof exampleHabits)[];
const hands = Object.fromEntries(names.map((name) => [name, learnHand(drawSwatches(exampleHabits[name], 1))]));

interface Drawn {
  /** The darkness of each tone, in the order in which they were given. */
  darkness: number[];
  /** The lengths and areas of whole strokes in the first tone. */
  pieces: Piece[];
}

interface Piece {
  length: number;
  area: number;
  /** How far the ends of a piece along the rows of `slant` lean to the sides, as a share of its width: 0 for ends straight across. */
  lean: number;
}

/** Draws a plane that faces the camera in several tones. */
const drawPlane = (page: Page, hand: object | null, tones: readonly number[], direction = 'x'): Promise<Drawn> =>
  page.evaluate(
    async ([hand, tones, direction, side]) => {
      const { THREE, HatchingMaterial, makeRenderer, makeCamera, sceneOf, sun, wholePieces } = window.toolkit;
      const material = new HatchingMaterial({
        technique: 'pen',
        direction,
        hand,
        screenSpaceShare: 1,
        toneCurve: 'linear',
        reflectedLight: 0,
      } as object);
      await material.ready;
      const renderer = makeRenderer();
      renderer.setSize(side, side, false);
      const mesh = new THREE.Mesh(new THREE.PlaneGeometry(3, 3), material);
      const shots = tones.map((tone) => {
        const z = 1 - tone;
        renderer.render(sceneOf(mesh, sun(Math.PI, [Math.sqrt(1 - z * z), 0, z])), makeCamera());
        const gl = renderer.getContext();
        const pixels = new Uint8Array(4 * side * side);
        gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        return Float32Array.from({ length: side * side }, (_, i) => 1 - pixels[4 * i] / 255);
      });
      const darkness = shots.map((shot) => shot.reduce((sum, value) => sum + value, 0) / shot.length);
      const pieces = wholePieces(side, (i) => shots[0][i] > 0.35).map((piece) => {
        const [xs, ys] = [piece.map((i) => i % side), piece.map((i) => Math.floor(i / side))];
        const extent = (values: number[]): number => Math.max(...values) - Math.min(...values) + 1;
        const places = piece.map((_, i) => [0.8 * xs[i] - 0.6 * ys[i], 0.6 * xs[i] + 0.8 * ys[i]]);
        const middle = [0, 1].map((k) => places.reduce((sum, place) => sum + place[k], 0) / places.length);
        const [along, across] = [0, 1].map((k) => places.map((place) => place[k] - middle[k]));
        const [long, wide] = [extent(along), extent(across)];
        // The outermost parts, half as long as the piece is wide.
        const ends = piece.map((_, i) => i).filter((i) => Math.abs(along[i]) > 0.5 * (long - wide));
        const lean = ends.reduce((sum, i) => sum + Math.sign(along[i]) * across[i], 0) / ends.length / wide;
        return { length: Math.hypot(extent(xs), extent(ys)), area: piece.length, lean };
      });
      material.dispose();
      return { darkness, pieces };
    },
    [hand, tones, direction, SIDE] as const,
  );

/** The length up to which pieces have half of all ink. */
function inkMedian(pieces: Drawn['pieces']): number {
  const sorted = [...pieces].sort((a, b) => a.length - b.length);
  const half = 0.5 * sorted.reduce((sum, { area }) => sum + area, 0);
  let sum = 0;
  for (const { length, area } of sorted) {
    sum += area;
    if (sum >= half) return length;
  }
  return 0;
}

for (const name of names) {
  test(`strokes of a hand are whole, and make the tone: ${name}`, async ({ page }) => {
    const tones = [0.08, 0.03, 0.25, 0.4, 0.55, 0.7, 0.85, 0.95];
    const { darkness, pieces } = await drawPlane(page, hands[name], tones);
    const ratio = inkMedian(pieces) / (SCALE * hands[name].numbers.length);
    const measured = `${ratio.toFixed(2)} of the drawn length; ${darkness.map((d) => d.toFixed(3)).join(', ')}`;
    test.info().annotations.push({ type: 'measured', description: measured });
    for (const [i, tone] of tones.entries())
      expect(Math.abs(darkness[i] - tone), `${tone} of ${measured}`).toBeLessThan(0.03);
    // A tool that skips tears its strokes on the sheet too.
    expect(ratio, measured).toBeGreaterThan('skips' in exampleHabits[name] ? 0.4 : 0.7);
  });
}

test('strokes end straight across their rows, also where these run askew to the axis along which they are counted', async ({
  page,
}) => {
  const { numbers } = hands.feltTip;
  const ruled = { ...hands.feltTip, numbers: { ...numbers, angleSpread: 0, wobble: 0, curvature: 0, overlap: -0.5 } };
  const { pieces } = await drawPlane(page, ruled, [0.06], 'slant');
  const strokes = pieces.filter(({ length }) => length > 0.7 * SCALE * numbers.length);
  const lean = strokes.reduce((sum, piece) => sum + piece.lean, 0) / strokes.length;
  const measured = `${strokes.length} strokes lean by ${lean.toFixed(3)}`;
  test.info().annotations.push({ type: 'measured', description: measured });
  expect(strokes.length).toBeGreaterThan(5);
  expect(Math.abs(lean), measured).toBeLessThan(0.05);
});

/** The lengths of whole strokes on a wall that is blank but for the shadows of bars, across which rows run. */
const shadedPieces = (page: Page, hand: object, isSun: boolean): Promise<number[]> =>
  page.evaluate(
    async ([hand, side, isSun]) => {
      const { THREE, HatchingMaterial, loadSunLight, makeRenderer, makeCamera, sceneOf, wholePieces } = window.toolkit;
      const material = new HatchingMaterial({
        ...{ technique: 'pen', direction: 'y', hand, screenSpaceShare: 1, toneCurve: 'linear', reflectedLight: 0 },
      } as object);
      await material.ready;
      const wall = new THREE.Mesh(new THREE.PlaneGeometry(4, 4), material);
      const bars = [-1, 1].map((x) => {
        const bar = new THREE.Mesh(new THREE.PlaneGeometry(1.1, 8), new THREE.MeshBasicMaterial({ side: 2 }));
        bar.position.set(x, 0, 6);
        bar.castShadow = true;
        return bar;
      });
      const Light = (isSun && (await loadSunLight())) || THREE.DirectionalLight;
      const light = new Light(0xffffff, 0.2 * Math.PI);
      light.position.set(0, 0, 8);
      light.castShadow = wall.receiveShadow = true;
      light.shadow.mapSize.setScalar(1024);
      if (!isSun) Object.assign(light.shadow.camera, { left: -2, right: 2, bottom: -2, top: 2, near: 1, far: 20 });
      const renderer = makeRenderer();
      renderer.shadowMap.enabled = true;
      renderer.setSize(side, side, false);
      renderer.render(sceneOf(wall, ...bars, light, new THREE.AmbientLight(0xffffff, 0.8 * Math.PI)), makeCamera());
      const gl = renderer.getContext();
      const pixels = new Uint8Array(4 * side * side);
      gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      material.dispose();
      return wholePieces(side, (i) => pixels[4 * i] < 165).map((piece) => {
        const [xs, ys] = [piece.map((i) => i % side), piece.map((i) => Math.floor(i / side))];
        return Math.hypot(Math.max(...xs) - Math.min(...xs) + 1, Math.max(...ys) - Math.min(...ys) + 1);
      });
    },
    [hand, SIDE, isSun] as const,
  );

for (const name of ['a shadow', 'a shadow of a sun']) {
  test(`strokes of a hand end at the hard edge of ${name}, and are not cut to flecks`, async ({ page }) => {
    const { numbers } = hands.feltTip;
    const even = { ...numbers, angleSpread: 0, wobble: 0, curvature: 0, lengthSpread: 0, crossingFrom: 1 };
    const hand = { ...hands.feltTip, numbers: { ...even, width: 0.35, spacing: 1.6, clustering: 0, overlap: -0.3 } };
    const lengths = await shadedPieces(page, hand, name.endsWith('sun'));
    const short = lengths.filter((length) => length < 0.55 * SCALE * numbers.length);
    const measured = `${short.length} of ${lengths.length} strokes`;
    test.info().annotations.push({ type: 'measured', description: measured });
    expect(lengths.length).toBeGreaterThan(100);
    // Some of the first strokes of a tone are growing.
    expect(short.length / lengths.length, measured).toBeLessThan(0.2);
  });
}

/** The luminance of the pixels of a wall in one tone, from 0 to 255. */
const wallOf = (
  page: Page,
  hand: Hand,
  direction: 'x' | 'y' | 'form',
  tone: number,
  strokeWidth: number | null = null,
): Promise<number[]> =>
  page.evaluate(
    async ([hand, direction, tone, strokeWidth, side]) => {
      const { THREE, HatchingMaterial, makeRenderer, makeCamera, prepareHatchingGeometry, sceneOf, sun } =
        window.toolkit;
      const look = { screenSpaceShare: 1, toneCurve: 'linear', reflectedLight: 0, strokeWidth } as const;
      const material = new HatchingMaterial({ technique: 'pen', direction, hand, ...look });
      await material.ready;
      const geometry = await prepareHatchingGeometry(new THREE.PlaneGeometry(4, 4, 8, 8), { form: true });
      const renderer = makeRenderer();
      renderer.setSize(side, side, false);
      const z = 1 - tone;
      renderer.render(
        sceneOf(new THREE.Mesh(geometry, material), sun(Math.PI, [Math.sqrt(1 - z * z), 0, z])),
        makeCamera(),
      );
      const gl = renderer.getContext();
      const pixels = new Uint8Array(4 * side * side);
      gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      material.dispose();
      return Array.from({ length: side * side }, (_, i) => pixels[4 * i]);
    },
    [hand, direction, tone, strokeWidth, SIDE] as const,
  );

/** How far strokes lean: from −1, all from the lower left to the upper right, to 1; 0 for those along the sides of the picture. */
function leanOf(pixels: readonly number[], side: number): number {
  let [crossed, all] = [0, 0];
  for (let i = side; i < pixels.length - side; i++) {
    const dx = pixels[i + 1] - pixels[i - 1];
    const dy = pixels[i + side] - pixels[i - side];
    crossed += 2 * dx * dy;
    all += dx * dx + dy * dy;
  }
  return crossed / all;
}

/** The distances of strokes side by side on a wall with horizontal rows, in pixels. */
function distancesAcross(pixels: readonly number[], side: number): number[] {
  const distances: number[] = [];
  for (let x = 0; x < side; x += 3) {
    let [start, last] = [-1, -1];
    for (let y = 0; y < side; y++) {
      const isInked = pixels[y * side + x] < 128;
      if (isInked && start < 0) start = y;
      if (isInked || start < 0) continue;
      const middle = (start + y) / 2;
      if (last >= 0) distances.push(middle - last);
      [start, last] = [-1, middle];
    }
  }
  return distances;
}

test('strokes of a hand with clustering stand in bundles, in the same tone', async ({ page }) => {
  const { numbers } = hands.feltTip;
  const ruled = { ...numbers, angleSpread: 0, wobble: 0, curvature: 0, spacingSpread: 0, lengthSpread: 0.1 };
  const walls = [];
  for (const clustering of [0, 0.45, 1]) {
    const hand = { ...hands.feltTip, numbers: { ...ruled, width: 0.3, spacing: 1.6, crossingFrom: 1, clustering } };
    const pixels = await wallOf(page, hand, 'y', 0.32);
    const distances = distancesAcross(pixels, SIDE);
    const mean = distances.reduce((sum, one) => sum + one, 0) / distances.length;
    const spread = Math.sqrt(distances.reduce((sum, one) => sum + (one / mean - 1) ** 2, 0) / distances.length);
    walls.push({ darkness: 1 - pixels.reduce((sum, one) => sum + one / 255, 0) / pixels.length, mean, spread });
  }
  const measured = JSON.stringify(walls);
  test.info().annotations.push({ type: 'measured', description: measured });
  for (const { darkness } of walls) expect(Math.abs(darkness - 0.32), measured).toBeLessThan(0.03);
  const [even, bundled, tight] = walls;
  expect(bundled.spread, measured).toBeGreaterThan(1.3 * even.spread);
  // The strokes of a bundle touch.
  expect(tight.mean, measured).toBeGreaterThan(1.7 * even.mean);
});

/** Strokes on a wall with level rows of a hand that has this overlap, as far as they are measured in pixels. */
interface StrokesBeside {
  darkness: number;
  /** How much of the mean length lies beside the next stroke of the row, in the mean, and the mean length over the hand's. */
  overlap: number;
  length: number;
}

/** The tone in which strokes that are all there and not wider than drawn cover a wall, without overlap. */
const FULL_TONE = 0.225;

async function strokesBeside(page: Page, overlap: number, tone: number): Promise<StrokesBeside> {
  const width = 5;
  const { numbers } = hands.feltTip;
  const ruled = { ...numbers, angleSpread: 0, wobble: 0, curvature: 0, spacingSpread: 0, lengthSpread: 0 };
  const sized = { length: 3.2, width: 0.5, spacing: 4, clustering: 0, crossingFrom: 1 };
  const hand = { ...hands.feltTip, numbers: { ...ruled, ...sized, overlap } };
  const pixels = await wallOf(page, hand, 'y', tone, width);
  const found = await page.evaluate(([pixels, side]) => window.toolkit.wholePieces(side, (i) => pixels[i] < 200), [
    pixels,
    SIDE,
  ] as const);
  const pieces = found.map((piece) => {
    const xs = piece.map((i) => i % SIDE);
    const y = piece.reduce((sum, i) => sum + Math.floor(i / SIDE), 0) / piece.length;
    return { from: Math.min(...xs), to: Math.max(...xs) + 1, y };
  });
  const length = pieces.reduce((sum, { from, to }) => sum + to - from, 0) / pieces.length;
  // Lanes of a row lie nearer to each other than two strokes are wide.
  const gaps = pieces.flatMap(({ from, to, y }) => {
    const after = pieces.filter((other) => Math.abs(other.y - y) < 2 * width && other.from > from);
    const gap = Math.min(...after.map((other) => other.from)) - to;
    // Where a stroke is missing none is the next.
    return from + 3 * length < SIDE && gap < length ? [gap] : [];
  });
  return {
    darkness: 1 - pixels.reduce((sum, one) => sum + one / 255, 0) / pixels.length,
    overlap: -gaps.reduce((sum, gap) => sum + gap, 0) / gaps.length / length,
    length: length / ((sized.length * width) / sized.width),
  };
}

test('strokes of a hand run beside the next one of their row by its overlap, as long as ever and in the same tone', async ({
  page,
}) => {
  const apart = await strokesBeside(page, -0.4, FULL_TONE / 1.4);
  for (const overlap of [0.15, 0.3, 0.45]) {
    const tone = FULL_TONE / (1 - overlap);
    const found = await strokesBeside(page, overlap, tone);
    const measured = `${overlap}: ${JSON.stringify(found)}`;
    test.info().annotations.push({ type: 'measured', description: measured });
    expect(Math.abs(found.darkness - tone), measured).toBeLessThan(0.035);
    expect(Math.abs(found.overlap - overlap), measured).toBeLessThan(Math.max(0.15 * overlap, 0.04));
    expect(Math.abs(found.length / apart.length - 1), measured).toBeLessThan(0.05);
  }
});

for (const [direction, clockwise] of [
  ['x', -1],
  ['y', 1],
  ['form', -1],
] as const) {
  test(`the second layer of a hand is turned from the first as on the sheet, clockwise or back: ${direction}`, async ({
    page,
  }) => {
    const still = { angleSpread: 0, wobble: 0, curvature: 0, crossingFrom: 0.3 };
    const { numbers } = hands.feltTip;
    const leanAt = async (crossingAngle: number): Promise<number> => {
      const hand = { ...hands.feltTip, numbers: { ...numbers, ...still, crossingAngle } };
      return leanOf(await wallOf(page, hand, direction, 0.6), SIDE);
    };
    const leans: number[] = [];
    for (const angle of [-50, 0, 50]) leans.push(clockwise * (await leanAt(angle)));
    const measured = leans.map((lean) => lean.toFixed(3)).join(', ');
    test.info().annotations.push({ type: 'measured', description: measured });
    expect(leans[0], measured).toBeLessThan(-0.2);
    expect(Math.abs(leans[1]), measured).toBeLessThan(0.05);
    expect(leans[2], measured).toBeGreaterThan(0.2);
  });
}

test('another hand is drawn with the same program and the same texture, and null draws the strokes of the pen', async ({
  page,
}) => {
  const { programs, textures, shots, before } = await page.evaluate(
    async ([brush, woodcut]) => {
      const { THREE, HatchingMaterial, makeRenderer, pixelsOf, sceneOf, sun } = window.toolkit;
      const pen = { technique: 'pen', direction: 'x', screenSpaceShare: 1 } as const;
      const material = new HatchingMaterial({ ...pen, hand: brush });
      await material.ready;
      const renderer = makeRenderer();
      const scene = sceneOf(new THREE.Mesh(new THREE.PlaneGeometry(3, 3), material), sun(Math.PI, [1, 0, 0.5]));
      const shots = [pixelsOf(scene, renderer)];
      const { programs, memory } = renderer.info;
      const before = { programs: programs!.length, textures: memory.textures };
      material.hand = { ...woodcut };
      shots.push(pixelsOf(scene, renderer));
      const after = { programs: programs!.length, textures: memory.textures };
      material.hand = null;
      shots.push(pixelsOf(scene, renderer));
      material.technique = 'pen';
      const plain = new HatchingMaterial(pen);
      shots.push(
        pixelsOf(sceneOf(new THREE.Mesh(new THREE.PlaneGeometry(3, 3), plain), sun(Math.PI, [1, 0, 0.5])), renderer),
      );
      material.dispose();
      return { ...after, shots, before };
    },
    [hands.brush, hands.woodcut] as const,
  );
  expect({ programs, textures }).toEqual(before);
  const differing = (a: number[], b: number[]): number =>
    a.filter((value, i) => Math.abs(value - b[i]) > 64).length / a.length;
  expect(differing(shots[0], shots[1])).toBeGreaterThan(0.1);
  expect(differing(shots[1], shots[2])).toBeGreaterThan(0.1);
  expect(shots[2]).toEqual(shots[3]);
});

/** Hands with a fault, by what is said of them. */
const faultsOf = (hand: Hand): [said: string, fault: unknown][] => [
  ['version 1', { ...hand, version: 2 }],
  ['a hand of version 1', 'hand.json'],
  ['a hand of version 1', { ...hand, strokes: [] }],
  ['all strokes are dots', { ...hand, strokes: [{ points: [0, 0, 0, 0], widths: [1, 1] }] }],
  ['all strokes are dots', { ...hand, strokes: hand.strokes.map(({ points }) => dotOf(points)) }],
  ['points\\[1\\] is null', { ...hand, strokes: [{ points: [0, null, 9, 0], widths: [1, 1] }] }],
  ['numbers.width is NaN', { ...hand, numbers: { ...hand.numbers, width: Number.NaN } }],
  ['numbers.length is 0', { ...hand, numbers: { ...hand.numbers, length: 0 } }],
];

/** A stroke as far as its first point, ten times as wide as long. */
const dotOf = ([x, y]: readonly number[]): HandStroke => ({ points: [x, y, x + 0.1, y], widths: [1, 1] });

test('a hand with a fault is refused in a sentence, and the last one stays: of materials, presets and their changes', async ({
  page,
}) => {
  const faults = faultsOf(hands.brush);
  const { told, stay } = await page.evaluate(
    async ([hand, faults]) => {
      const { THREE, applyHatching, HatchingMaterial, presets, sceneOf, sun } = window.toolkit;
      const material = new HatchingMaterial({ technique: 'pen', hand });
      await material.ready;
      const scene = () => sceneOf(new THREE.Mesh(new THREE.SphereGeometry(), new THREE.MeshBasicMaterial()), sun());
      const drawn = scene();
      const hatched = await applyHatching(drawn, { preset: 'pen', outlines: false, material: { hand } });
      const [inScene] = hatched.materials;
      const told: string[][] = [];
      for (const fault of faults as (typeof hand)[]) {
        const mine = { ...presets.pen, material: { ...presets.pen.material, hand: fault } };
        const ways = [
          async () => Object.assign(material, { hand: fault }),
          async () => material.setValues({ strokeWidth: 3, hand: fault }),
          async () => new HatchingMaterial({ technique: 'pen', hand: fault }),
          () => applyHatching(scene(), { preset: mine, outlines: false }),
          () => hatched.setPreset('pen', { material: { hand: fault } }),
        ];
        const messages: string[] = [];
        for (const way of ways) messages.push(await way().then(() => 'no error', String));
        told.push(messages);
      }
      const stay = [
        material.hand === hand,
        inScene === hatched.materials[0],
        (inScene as typeof material).hand === hand,
      ];
      hatched.dispose();
      material.dispose();
      return { told, stay };
    },
    [hands.brush, faults.map(([, fault]) => fault)] as const,
  );
  for (const [i, [said]] of faults.entries())
    for (const message of told[i]) expect(message).toMatch(new RegExp(`^(TypeError|RangeError): .*${said}.*\\.$`));
  expect(stay).toEqual([true, true, true]);
});

test('a hand of one stroke, of a thousand, or 100 mm wide is drawn in its tone', async ({ page }) => {
  const { brush } = hands;
  const drawn = {
    'one stroke': { ...brush, strokes: brush.strokes.slice(0, 1) },
    'a thousand': {
      ...brush,
      strokes: Array.from({ length: 1000 }, (_, i) => brush.strokes[i % brush.strokes.length]),
    },
    '100 mm': { ...brush, numbers: { ...brush.numbers, width: 100 } },
  };
  for (const [name, hand] of Object.entries(drawn)) {
    const { darkness } = await drawPlane(page, hand, [0.4, 0.95]);
    test.info().annotations.push({ type: 'measured', description: `${name}: ${darkness.join(', ')}` });
    // The picture lies within two or three strokes of 100 mm.
    const most = name === '100 mm' ? 0.35 : 0.05;
    expect(Math.abs(darkness[0] - 0.4), `${name}: ${darkness}`).toBeLessThan(most);
    expect(Math.abs(darkness[1] - 0.95), `${name}: ${darkness}`).toBeLessThan(most);
  }
});

test('strokes of a hand end on degenerate surfaces', async ({ page }) => {
  const darkness = await page.evaluate(async (hand) => {
    const { THREE, HatchingMaterial, makeRenderer, pixelsOf, prepareHatchingGeometry, sceneOf, sun } = window.toolkit;
    const renderer = makeRenderer();
    const sums: number[] = [];
    for (const direction of ['x', 'light', 'form'] as const) {
      const material = new HatchingMaterial({ technique: 'pen', direction, hand, screenSpaceShare: 1 });
      await material.ready;
      for (const [name, value] of [
        ['normal', 0],
        ['normal', Number.NaN],
        ['position', 0],
        ['formSlope', 0],
      ] as const) {
        const geometry = await prepareHatchingGeometry(new THREE.SphereGeometry(1.2, 12, 8), { form: true });
        const attribute = geometry.getAttribute(name);
        // Every third vertex: triangles lose their normal, their area or their function.
        for (let i = 0; i < attribute.count; i += 3)
          for (let k = 0; k < attribute.itemSize; k++) attribute.setComponent(i, k, value);
        const pixels = pixelsOf(sceneOf(new THREE.Mesh(geometry, material), sun()), renderer);
        sums.push(pixels.reduce((sum, pixel) => sum + pixel, 0));
      }
      material.dispose();
    }
    return sums;
  }, hands.brush);
  expect(darkness).toHaveLength(12);
  for (const sum of darkness) expect(sum).toBeGreaterThan(0);
});
