import { mat4, vec3 } from 'gl-matrix';
import { expect, test } from 'vitest';
import { dot, type Vec3 } from '../../../../src/look/vectors.js';
import { STIPPLE_MAP_SIZE } from '../../../../src/material/tam/patternSizes.js';
import { stippleMap } from '../../../../src/material/tam/stippleMap.js';
import { screenGradient, screenMap } from '../../../../src/vector/shading/screenGradient.js';
import {
  coverOf,
  directionOfNeedles,
  dotArea,
  dotOctave,
  grownBy,
  ownCover,
  planesNear,
  roundScreenMap,
  setShift,
} from '../../../../src/vector/shading/stipple.js';
import type { HatchingReference } from '../../../reference/hatchingReference.js';
import { StippleReference } from '../../../reference/stippleReference.js';
import { randomNumbers } from '../randomNumbers.js';

const SIZE = 480;
const random = randomNumbers(29);
const between = (from: number, to: number): number => from + (to - from) * random();
const place3 = (reach: number): [number, number, number] => [
  between(-reach, reach),
  between(-reach, reach),
  between(-reach, reach),
];
const view = mat4.lookAt(mat4.create(), [1, 1.5, 4], [0, 0, 0], [0, 1, 0]);
const matrixWorld = mat4.fromRotation(mat4.create(), 0.7, [1, 2, 0.5])!;
const texels = stippleMap().image.data as Uint8Array;
const wrap = (cell: number) => ((cell % STIPPLE_MAP_SIZE) + STIPPLE_MAP_SIZE) % STIPPLE_MAP_SIZE;

/** The ink of a disc with an edge one pixel wide, by the distance from its middle. */
function discInk(away: number, area: number): number {
  const squared = area / Math.PI;
  const radius = Math.sqrt(Math.max(squared - 1 / 12, 0.25));
  return Math.min(Math.max(radius - away + 0.5, 0), 1) * Math.min(3 * squared, 1);
}

test.each([
  ['perspective', mat4.perspective(mat4.create(), 0.8, 1, 0.1, 50)],
  ['orthographic', mat4.ortho(mat4.create(), -2, 2, -2, 2, 0.1, 50)],
])('dots are those of the reference, %s', (name, projection) => {
  const isOrthographic = name === 'orthographic';
  const toView = mat4.multiply(mat4.create(), view, matrixWorld);
  const back = mat4.invert(mat4.create(), toView)!;
  const toObject = (v: Vec3): Vec3 =>
    [0, 1, 2].map((i) => dot([back[i], back[4 + i], back[8 + i]], v)) as unknown as Vec3;
  let inked = 0;
  for (let i = 0; i < 300; i++) {
    const place = place3(1);
    const size = { dotPixels: between(1.5, 6), tilesPerUnit: between(0.1, 1), sizedOnScreen: random() };
    // In the lightest tones the spacing of dots is constant.
    const tone = i % 4 === 0 ? between(0.002, 0.02) : between(0.02, 0.84);
    const seen = vec3.transformMat4([0, 0, 0], place, toView) as Vec3;
    const toViewer = vec3.normalize(
      [0, 0, 0],
      toObject(isOrthographic ? [0, 0, 1] : [-seen[0], -seen[1], -seen[2]]) as vec3,
    ) as Vec3;
    // Front faces only.
    let normal = vec3.normalize([0, 0, 0], place3(1)) as Vec3;
    if (dot(normal, toViewer) < 0) normal = [-normal[0], -normal[1], -normal[2]];
    const reference = {
      toWorld: (p: Vec3) => p,
      tone: () => tone,
      toViewer: () => [...toViewer],
    } as unknown as HatchingReference;
    const stipple = new StippleReference({
      ...{ reference, matrixWorld: [...matrixWorld], size: SIZE },
      camera: { view: [...view], projection: [...projection] },
      settings: {
        tilesPerUnit: size.tilesPerUnit,
        strokeWidth: size.dotPixels,
        sizedOnScreen: size.sizedOnScreen,
        edgePixels: 1,
      },
    });
    const expected = stipple.darkness([...place], [...normal] as [number, number, number], [0, 1, 0]);
    const unitsPerPixel = (2 * (isOrthographic ? 1 : -seen[2])) / (projection[5] * SIZE);
    const rows = [0, 1, 2].map((r): Vec3 => [back[r], back[4 + r], back[8 + r]]) as unknown as [Vec3, Vec3, Vec3];
    const map = roundScreenMap(screenMap(normal, rows, { view: seen, isOrthographic, unitsPerPixel }), unitsPerPixel);
    const cover = coverOf(tone);
    let blank = Math.min((1 - cover) / 0.03, 1);
    for (const { axis, u, v, share } of planesNear(directionOfNeedles(normal, toViewer))) {
      const [gu, gv] = [screenGradient(u, map), screenGradient(v, map)];
      const area = gu[0] * gv[1] - gu[1] * gv[0];
      const own = ownCover(cover, share);
      const octave = dotOctave(Math.abs(area), own, size);
      const cells = 2 ** (Math.floor(octave) + 1);
      const full = dotArea(Math.abs(area), own, octave);
      const shift = setShift(axis, size.tilesPerUnit);
      const at = [cells * (dot(place, u) + shift[0]), cells * (dot(place, v) + shift[1])];
      let ink = 0;
      for (let y = Math.floor(at[1]) - 3; y <= at[1] + 3; y++) {
        for (let x = Math.floor(at[0]) - 3; x <= at[0] + 3; x++) {
          const texel = 4 * (wrap(y) * STIPPLE_MAP_SIZE + wrap(x));
          const du = (x + texels[texel] / 255 - at[0]) / cells;
          const dv = (y + texels[texel + 1] / 255 - at[1]) / cells;
          const away = Math.hypot((du * gv[1] - dv * gu[1]) / area, (dv * gu[0] - du * gv[0]) / area);
          ink += discInk(away, full * grownBy(octave - Math.floor(octave), texels[texel + 2] / 255));
        }
      }
      blank *= 1 - Math.min(ink, 1);
    }
    expect(Math.abs(1 - blank - expected)).toBeLessThan(1e-6);
    if (expected > 0.3) inked++;
  }
  expect(inked).toBeGreaterThan(60);
});
