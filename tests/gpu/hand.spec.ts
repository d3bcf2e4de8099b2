import type { Page } from '@playwright/test';
import { learnHand } from '../../src/strokes/hand/learnHand.js';
import { drawSwatches } from '../../src/strokes/hands/drawSwatch.js';
import { exampleHabits } from '../../src/strokes/hands/exampleHabits.js';
import { FlipCount } from '../../tools/metrics/measures/normalisedFlips.js';
import { poppingIndex } from '../../tools/metrics/measures/reprojectedChange.js';
import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

/** A film strip of a light that moves around a ball, drawn with a hand: strokes swell and thin, and none pop. */

const SIDE = 256;
const FRAMES = 24;

/** Five slanted strokes, which swell in their middle: the least that the page takes. */
const five = learnHand(
  Array.from({ length: 5 }, (_, i) => {
    const shares = Array.from({ length: 12 }, (_, k) => k / 11);
    return {
      points: shares.flatMap((share) => [5 + 3 * i + 6 * share, 40 - 14 * share + share * (1 - share) * (2 + i)]),
      widths: shares.map((share) => 0.15 + 0.6 * Math.sin(Math.PI * (0.1 + 0.8 * share))),
    };
  }),
);

test('while the light moves, a map by a hand pops no more than hatching', { tag: '@all' }, async ({ page }) => {
  const hatching = await film(page, { style: 'hatching' });
  for (const [name, hand] of [
    ['five strokes', five],
    ['a reed pen', learnHand(drawSwatches(exampleHabits.reedPen, 1))],
  ] as const) {
    const drawn = await film(page, { hand });
    test.info().annotations.push({
      type: name,
      description: [hatching, drawn]
        .map(({ worst, popping }) => `${worst.toFixed(4)} (${popping.toFixed(2)})`)
        .join(', '),
    });
    // The strokes are visible: pixels change from frame to frame.
    expect(Math.min(hatching.worst, drawn.worst), name).toBeGreaterThan(0.005);
    expect(drawn.worst, name).toBeLessThanOrEqual(1.05 * hatching.worst);
    expect(drawn.popping, name).toBeLessThanOrEqual(1.1 * hatching.popping);
  }
});

/** The share of pixels that change between two frames at the most, beside noise, and how much that frame stands out. */
async function film(page: Page, drawing: object): Promise<{ worst: number; popping: number }> {
  const frames = await page.evaluate(
    async ([drawing, side, count]) => {
      const { THREE, TonalArtMap, hatchedMesh, makeRenderer, makeCamera, sceneOf, sun } = window.toolkit;
      const tonalArtMap = await TonalArtMap.generate(drawing);
      const mesh = await hatchedMesh(new THREE.SphereGeometry(1.2, 48, 32), {
        technique: 'hatching',
        tonalArtMap,
        tilesPerObjectUnit: 1.5,
      });
      const renderer = makeRenderer();
      renderer.setSize(side, side, false);
      const camera = makeCamera();
      const gl = renderer.getContext();
      return Array.from({ length: count }, (_, frame) => {
        const angle = ((20 + 1.5 * frame) * Math.PI) / 180;
        const scene = sceneOf(mesh, sun(Math.PI, [2 * Math.cos(angle), 1, 2 * Math.sin(angle)]));
        renderer.render(scene, camera);
        const pixels = new Uint8Array(side * side * 4);
        gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        // The ground is green, and paper and ink are grey. As text, which is passed much faster than a list of numbers.
        return Array.from({ length: side * side }, (_, i) =>
          pixels[4 * i + 1] > pixels[4 * i] + 60 ? ' ' : pixels[4 * i] < 128 ? '#' : '.',
        ).join('');
      });
    },
    [drawing, SIDE, FRAMES] as const,
  );
  const changes = frames.slice(1).map((after, i) => {
    const count = new FlipCount();
    for (let k = 0; k < after.length; k++) {
      if (frames[i][k] !== ' ' && after[k] !== ' ') count.add(frames[i][k] === '#', after[k] === '#');
    }
    return count.normalised();
  });
  return { worst: Math.max(...changes), popping: poppingIndex(changes) };
}
