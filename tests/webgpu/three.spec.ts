import { expect } from '../browser/test.js';
import { test, testGroup } from './besideGlsl.js';

testGroup('three');

test('another colour is noticed', async ({ page }) => {
  const measured = await page.evaluate(() => window.besideGlsl.measure('unlike', 'another colour', 'forceWebGL'));
  const { differing, tones, covered } = measured;
  expect(covered).toBeGreaterThan(0.1);
  expect(differing).toBeGreaterThan(0.1);
  expect(Math.abs(tones[1] - tones[0])).toBeGreaterThan(0.5);
});
