import type { Page } from '@playwright/test';
import { learnHand } from '../../src/strokes/hand/learnHand.js';
import { drawSwatches } from '../../src/strokes/hands/drawSwatch.js';
import { exampleHabits } from '../../src/strokes/hands/exampleHabits.js';
import { quickIf } from '../browser/quickIf.js';
import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Strokes of a hand leave as paths: the same as on the canvas, one path each. */

const test = onOnePage('tests/gpu/vector.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.vectors !== undefined);
});

interface Compared {
  /** How far the middles of strokes differ from those on the canvas, column by column, pixels, in rising order. */
  off: number[];
  /** The ink of the file over that of the canvas, of whole strokes alone. */
  ink: number;
  /** Whole strokes on the canvas that stand alone, and paths of the file. */
  strokes: number;
  paths: number;
}

/** A plane, one in the shadow of bars, and a sphere. */
type Body = 'plane' | 'shaded plane' | 'sphere';

/** Draws a body in light strokes whose rows are level, on the canvas and as a file. */
const compare = (page: Page, body: Body, hand: object, kind: 'print' | 'pen'): Promise<Compared> =>
  page.evaluate(
    async ([body, hand, kind]) => {
      const { THREE, HatchingMaterial, makeRenderer, makeCamera, prepareHatchingGeometry, wholePieces } =
        window.toolkit;
      const { drawSVG } = window.vectors;
      const side = 512;
      const material = new HatchingMaterial({
        ...{ technique: 'pen', direction: 'y', hand, screenSpaceShare: 1, toneCurve: 'linear', reflectedLight: 0 },
      } as object);
      material.ink.set('black');
      material.paper.set('white');
      await material.ready;
      const source = body === 'sphere' ? new THREE.SphereGeometry(1.3, 160, 100) : new THREE.PlaneGeometry(4, 4, 4, 4);
      const mesh = new THREE.Mesh(await prepareHatchingGeometry(source, { technique: 'pen' }), material);
      const scene = new THREE.Scene().add(mesh);
      scene.background = new THREE.Color('white');
      const z = { plane: 0.88, 'shaded plane': 0.98, sphere: 1 }[body];
      const light = new THREE.DirectionalLight(0xffffff, Math.PI);
      light.position.set(Math.sqrt(1 - z * z), 0, z);
      scene.add(light);
      const camera = makeCamera();
      const renderer = makeRenderer();
      if (body === 'shaded plane') {
        // Bars behind the camera, half as wide as the gaps between them.
        for (const x of [-1, 0, 1]) {
          const bar = new THREE.Mesh(new THREE.PlaneGeometry(0.4, 8), new THREE.MeshBasicMaterial({ side: 2 }));
          bar.position
            .copy(light.position)
            .multiplyScalar(12)
            .add(new THREE.Vector3(1.2 * x, 0, 0));
          bar.castShadow = true;
          scene.add(bar);
        }
        light.position.multiplyScalar(20);
        light.castShadow = mesh.receiveShadow = renderer.shadowMap.enabled = true;
        light.shadow.mapSize.setScalar(2048);
        Object.assign(light.shadow.camera, { left: -3, right: 3, bottom: -3, top: 3, near: 1, far: 40 });
        light.intensity *= 0.2;
        scene.add(new THREE.AmbientLight(0xffffff, 0.8 * Math.PI));
      }
      renderer.setSize(side, side, false);
      renderer.render(scene, camera);
      const millimetres = (side * 25.4) / 96;
      const inkOf = (image: CanvasImageSource, margin: number): Float32Array => {
        const canvas = document.createElement('canvas');
        canvas.width = canvas.height = side;
        const context = canvas.getContext('2d', { willReadFrequently: true })!;
        context.fillStyle = 'white';
        context.fillRect(0, 0, side, side);
        const out = (margin * side) / millimetres;
        context.drawImage(image, -out, -out, side + 2 * out, side + 2 * out);
        const { data } = context.getImageData(0, 0, side, side);
        return Float32Array.from({ length: side * side }, (_, i) => 1 - data[4 * i] / 255);
      };
      const drawn = inkOf(renderer.domElement, 0);
      // A pen keeps off the edge of the sheet.
      const margin = 1;
      const sheet = [millimetres + 2 * margin, millimetres + 2 * margin] as const;
      const { svg, paths } = await drawSVG(scene, camera, {
        ...{ sheet, margin, kind, shadows: body === 'shaded plane' },
        ...(kind === 'pen' && { penWidth: 0.3 }),
      });
      const image = new Image();
      image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
      await image.decode();
      const filed = inkOf(image, margin);
      const off: number[] = [];
      let [strokes, ofCanvas, ofFile] = [0, 0, 0];
      for (const piece of wholePieces(side, (i) => drawn[i] > 0.2)) {
        const [xs, ys] = [piece.map((i) => i % side), piece.map((i) => Math.floor(i / side))];
        const [left, right] = [Math.min(...xs) - 2, Math.max(...xs) + 2];
        const [top, bottom] = [Math.min(...ys) - 2, Math.max(...ys) + 2];
        // Strokes near others, near the border and near the rim of a body are left out.
        const far = Math.max(Math.hypot(left - 256, top - 256), Math.hypot(left - 256, bottom - 256));
        const away = Math.max(far, Math.hypot(right - 256, top - 256), Math.hypot(right - 256, bottom - 256));
        if (left < 0 || right >= side || top < 0 || bottom >= side || right - left < 20) continue;
        if (body === 'sphere' && away > 180) continue;
        const at = (ink: Float32Array, x: number, y: number): number => ink[side * y + x];
        let around = 0;
        for (let x = left; x <= right; x++) around += at(drawn, x, top) + at(drawn, x, bottom);
        for (let y = top; y <= bottom; y++) around += at(drawn, left, y) + at(drawn, right, y);
        if (around > 0.01) continue;
        strokes++;
        for (let x = left; x <= right; x++) {
          const sums = [drawn, filed].map((ink) => {
            let [sum, moment] = [0, 0];
            for (let y = top; y <= bottom; y++) {
              sum += at(ink, x, y);
              moment += y * at(ink, x, y);
            }
            return { sum, middle: moment / sum };
          });
          ofCanvas += sums[0].sum;
          ofFile += sums[1].sum;
          // Where strokes cross, the pen draws two lines.
          const isOne = kind === 'print' || sums[1].sum < 1.5;
          if (isOne && sums[0].sum > 0.4 && sums[1].sum > 0.4) off.push(Math.abs(sums[0].middle - sums[1].middle));
        }
      }
      material.dispose();
      return { off: off.sort((a, b) => a - b), ink: ofFile / ofCanvas, strokes, paths };
    },
    [body, hand, kind] as const,
  );

const at = ({ off }: Compared, share: number): number => off[Math.floor(share * (off.length - 1))];

for (const [body, name] of [
  ['plane', 'brush'],
  ['plane', 'scribble'],
  ['shaded plane', 'reedPen'],
  ['sphere', 'reedPen'],
  ['sphere', 'finePen'],
] as const)
  test(
    `strokes of a hand are paths where they are on the canvas: ${name}, ${body}`,
    quickIf(name === 'brush' || (name === 'reedPen' && body === 'sphere')),
    async ({ page }) => {
      const hand = learnHand(drawSwatches(exampleHabits[name], 1));
      const print = await compare(page, body, hand, 'print');
      const pen = await compare(page, body, hand, 'pen');
      const measured = [print, pen].map(({ off, ...rest }) => ({ p95: at({ off, ...rest }, 0.95), ...rest }));
      test.info().annotations.push({ type: 'measured', description: JSON.stringify(measured) });
      expect(print.strokes).toBeGreaterThan(10);
      for (const one of [print, pen]) expect(at(one, 0.95), JSON.stringify(measured)).toBeLessThan(0.3);
      expect(Math.abs(print.ink - 1), JSON.stringify(measured)).toBeLessThan(0.01);
    },
  );
