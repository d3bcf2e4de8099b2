import { learnHand } from '../../src/strokes/hand/learnHand.js';
import { drawSwatches } from '../../src/strokes/hands/drawSwatch.js';
import { exampleHabits } from '../../src/strokes/hands/exampleHabits.js';
import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

/** The hand of `<hatched-model>`. */

test('<hatched-model> draws with the hand that its attribute names, and says what is wrong with another', async ({
  page,
  pageProblems,
}) => {
  const hand = learnHand(drawSwatches(exampleHabits.brush, 1));
  const { told, pictures } = await page.evaluate(async (hand) => {
    const { GLTFExporter, THREE } = window.toolkit;
    await import('../../src/element/element.js');
    const model = new THREE.Mesh(new THREE.SphereGeometry(1, 48, 32), new THREE.MeshStandardMaterial());
    const glb = (await new GLTFExporter().parseAsync(model, { binary: true })) as ArrayBuffer;
    const element = document.createElement('hatched-model');
    element.style.cssText = 'position: fixed; left: 0; top: 0; width: 200px; height: 200px';
    element.src = URL.createObjectURL(new Blob([glb]));
    const said = () =>
      new Promise<string>((resolve) => {
        element.addEventListener('load', () => resolve('drawn'), { once: true });
        element.addEventListener('error', ({ message }) => resolve(message), { once: true });
      });
    const canvas = () => element.shadowRoot!.querySelector('canvas')!;
    const picture = async () => {
      // The frame after the one that is requested.
      for (let i = 0; i < 3; i++) await new Promise(requestAnimationFrame);
      const { data } = canvas().getContext('2d')!.getImageData(0, 0, canvas().width, canvas().height);
      return [...data.filter((_, i) => i % 4 === 0)];
    };
    const json = (text: string): string => `data:application/json,${encodeURIComponent(text)}`;
    const told: string[] = [];
    const pictures: number[][] = [];
    const change = async (attributes: Record<string, string>) => {
      const saying = said();
      Object.assign(element, attributes);
      told.push(await saying);
      pictures.push(await picture());
    };
    const first = said();
    document.body.append(element);
    told.push(await first);
    pictures.push(await picture());
    await change({ hand: json(JSON.stringify(hand)) });
    await change({ hand: json('{"version": 2}') });
    await change({ hand: json('no hand') });
    await change({ hand: json(JSON.stringify({ ...hand, strokes: [{ points: [0, 0, 0, 0], widths: [1, 1] }] })) });
    await change({ hand: 'none.json' });
    await change({ preset: 'chalk' });
    await change({ preset: 'pen', hand: '' });
    element.remove();
    return { told, pictures };
  }, hand);
  // The browser reports an address where there is nothing.
  pageProblems.splice(0);
  expect(told).toEqual([
    'drawn',
    'drawn',
    expect.stringMatching(/^The hand of the page could not be read: .* a hand of version 1/),
    expect.stringMatching(/^The hand of the page could not be read: .*JSON/),
    expect.stringMatching(/^The hand of the page could not be read: .*all strokes are dots/),
    expect.stringMatching(/^The hand "none.json" could not be (read|fetched): /),
    'A hand needs a preset that draws with a pen: pen, crossHatching.',
    'drawn',
  ]);
  const differing = (a: number[], b: number[]): number =>
    a.filter((value, i) => Math.abs(value - b[i]) > 64).length / a.length;
  const [plain, drawn] = pictures;
  expect(differing(plain, drawn)).toBeGreaterThan(0.02);
  // The last good hand stays.
  for (const picture of pictures.slice(2, 7)) expect(differing(picture, drawn)).toBeLessThan(0.005);
  expect(differing(pictures[7], plain)).toBeLessThan(0.005);
});
