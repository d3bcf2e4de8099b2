import { mat4 } from 'gl-matrix';
import { describe, expect, test } from 'vitest';
import type { Vec3 } from '../../../../src/look/vectors.js';
import { fadingAt, type ObjectFading, outlineFadingAt } from '../../../../src/vector/shading/fading.js';
import { HatchingReference, type ReferenceMaterial } from '../../../reference/hatchingReference.js';
import { randomNumbers } from '../randomNumbers.js';

const random = randomNumbers(23);
const between = (from: number, to: number): number => from + (to - from) * random();

const FULL: ObjectFading = {
  depthFading: [0, 1, 0],
  focus: null,
  vignette: 0,
  sheet: [0, 0, 1, 1],
  importance: 1,
};
const at = (depth: number) => ({ world: [0, 0, 0] as Vec3, depth, onPicture: [0.5, 0.5] as const });

/** The weight by the reference: the tone of a surface without light. */
function expectedWeight(
  material: Partial<ReferenceMaterial>,
  importance: number,
  camera: { view: number[]; projection: number[] },
  place: Vec3,
): number {
  const plain = { toneModel: 'lambert', toneCurve: 'linear', colorHatching: 0, color: [1, 1, 1], reflectedLight: 0 };
  const reference = new HatchingReference({
    ...{ matrixWorld: [...mat4.create()], eye: [1, 1.5, 4], lights: [], tones: 1, image: () => 0 },
    ...{ camera, importance, material: { ...plain, ...material } as ReferenceMaterial },
  });
  return reference.tone([...place], [0, 1, 0]);
}

test('the weight of a place is that of the reference', () => {
  const view = [...mat4.lookAt(mat4.create(), [1, 1.5, 4], [0, 0, 0], [0, 1, 0])];
  const projections = [
    [...mat4.perspective(mat4.create(), 0.8, 1.3, 0.1, 50)],
    [...mat4.ortho(mat4.create(), -2, 2, -2, 2, 0.1, 50)],
  ];
  let [blank, full] = [0, 0];
  for (let i = 0; i < 400; i++) {
    const projection = projections[i % 2];
    const place: Vec3 = [between(-2, 2), between(-2, 2), between(-2, 2)];
    const material = {
      depthFade: i % 3 === 0 ? 0 : random(),
      depthFadeStart: between(1, 4),
      depthFadeEnd: between(4.5, 7),
      focus: [between(-1, 1), between(-1, 1), between(-1, 1)] as [number, number, number],
      focusRadius: between(0.3, 2),
      vignette: i % 5 === 0 ? 0 : random(),
    };
    const importance = random();
    const seen = mat4.multiply(mat4.create(), projection as mat4, view as mat4);
    const clip = [0, 1, 3].map(
      (row) => seen[row] * place[0] + seen[4 + row] * place[1] + seen[8 + row] * place[2] + seen[12 + row],
    );
    const depth = -(view[2] * place[0] + view[6] * place[1] + view[10] * place[2] + view[14]);
    // As a part of a larger sheet it must be the same.
    const [x, y] = [0.5 + (0.5 * clip[0]) / clip[2], 0.5 + (0.5 * clip[1]) / clip[2]];
    const found = fadingAt(
      {
        depthFading: [material.depthFadeStart, material.depthFadeEnd, material.depthFade],
        focus: { at: material.focus, radius: material.focusRadius },
        vignette: material.vignette,
        sheet: [-0.5, -0.25, 2, 3],
        importance,
      },
      { world: place, depth, onPicture: [2 * x - 0.5, 3 * y - 0.25] },
    );
    const expected = expectedWeight(material, importance, { view, projection }, place);
    expect(Math.abs(found - expected)).toBeLessThan(1e-9);
    if (expected === 0) blank++;
    if (expected > 0.05) full++;
  }
  expect(blank).toBeGreaterThan(10);
  expect(full).toBeGreaterThan(50);
});

describe('outlines', () => {
  test('are 1.4 times as heavy in front if the back has none, and as usual without fading', () => {
    const fading: ObjectFading = { ...FULL, depthFading: [2, 6, 1] };
    expect(outlineFadingAt(fading, at(2))).toBeCloseTo(1.4, 12);
    expect(outlineFadingAt(fading, at(6))).toBeCloseTo(0, 12);
    expect(outlineFadingAt({ ...FULL, depthFading: [2, 6, 0.5] }, at(1))).toBeCloseTo(1.2, 12);
    expect(outlineFadingAt(FULL, at(5))).toBe(1);
  });

  test('lose as much weight as surfaces', () => {
    expect(outlineFadingAt({ ...FULL, importance: 0.3 }, at(1))).toBeCloseTo(0.3, 12);
  });
});
