import { describe, expect, test } from 'vitest';
import { type FrontClues, frontEvidence, type MeasuredView } from '../../../../src/viewer/views/frontEvidence.js';

const NONE = { visibility: 0, cover: 0, outline: 0, depth: 0, relief: 0, inner: 0, sides: 0, backs: 0, near: 0 };
/** Views from the front and the back, of which the share of slopes is given. */
const views = (front: number, back: number): MeasuredView[] =>
  [front, back].map((slopes, i) => ({ azimuth: 180 * i, elevation: 15, measures: { ...NONE, slopes } }));
/** A column of points at each place along z, up to a height, and one at the middle up to 1. */
const columns = (...heights: [z: number, height: number][]): Float32Array =>
  Float32Array.from(
    [...heights, [0, 1]].flatMap(([z, height]) => [0, 0.25, 0.5, 0.75, 1].flatMap((share) => [0, share * height, z])),
  );
const level = columns([-1, 0.5], [1, 0.5]);

/** How much clearer the side of +z is the front than the side of −z. */
function lead(clues: Partial<FrontClues>, seen = views(0, 0)): number {
  const all = { points: level, squareness: 1, landmarks: [], ...clues };
  return frontEvidence(all, seen, 0) - frontEvidence(all, seen, 180);
}
/** That of nothing but the convention of formats. */
const usual = lead({});

describe('the front of a thing is', () => {
  test('the side of more slopes, and of an animal less so', () => {
    expect(lead({}, views(0.3, 0.1))).toBeGreaterThan(usual + 0.5);
    expect(lead({}, views(0.1, 0.3))).toBeLessThan(usual - 0.5);
    expect(lead({ squareness: 0 }, views(0.3, 0.1))).toBeLessThan(lead({}, views(0.3, 0.1)));
  });

  test('the lower half, but not of an animal', () => {
    const points = columns([-1, 0.7], [-0.5, 0.7], [0.5, 0.3], [1, 0.3]);
    expect(lead({ points })).toBeGreaterThan(usual + 0.3);
    expect(lead({ points, squareness: 0 })).toBeLessThan(usual + 0.3);
  });

  test('the side away from what is highest; of an animal, that of its head', () => {
    const points = columns([-1, 0.9], [-0.5, 0.1], [0.5, 0.5], [1, 0.5]);
    const [ofThing, ofAnimal] = [1, 0].map((squareness) => lead({ points, squareness }));
    const [usualThing, usualAnimal] = [1, 0].map((squareness) => lead({ squareness }));
    expect(ofThing).toBeGreaterThan(usualThing + 0.3);
    expect(ofAnimal).toBeLessThan(usualAnimal - 0.3);
  });

  test('the side of more relief, and of furniture less so', () => {
    const seen = views(0, 0).map((view, i) => ({ ...view, measures: { ...view.measures, relief: i === 0 ? 2 : 1 } }));
    const [ofThing, ofAnimal] = [1, 0].map((squareness) => lead({ squareness }, seen) - lead({ squareness }));
    expect(ofThing).toBeGreaterThan(0.5);
    expect(ofAnimal).toBeGreaterThan(2 * ofThing);
  });

  test('the side of parts that are named for it, by how far they lie there', () => {
    expect(lead({ landmarks: [{ x: 0, z: 1, sign: 1 }] })).toBeGreaterThan(usual + 1);
    expect(lead({ landmarks: [{ x: 0, z: 1, sign: -1 }] })).toBeLessThan(usual - 1);
    expect(lead({ landmarks: [{ x: 1, z: 0, sign: 1 }] })).toBeCloseTo(usual);
  });
});
