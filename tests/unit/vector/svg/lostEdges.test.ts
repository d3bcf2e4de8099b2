import {
  BoxGeometry,
  type BufferGeometry,
  CapsuleGeometry,
  SphereGeometry,
  TorusGeometry,
  TorusKnotGeometry,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';
import { pathsOf, ringsOf } from '../paths.js';

/** Contours whose edges are lost in the light. Lengths in millimetres. */

const BLANK = {
  toneCurve: [
    [0, 0],
    [1, 0],
  ] as [number, number][],
  hollowStrength: 0,
};
const SIDE = 120;
const PEN = 0.3;
const STEP = 0.1;

const MODELS: Readonly<Record<string, () => BufferGeometry>> = {
  ball: () => new SphereGeometry(0.9, 48, 32),
  boot: () =>
    mergeGeometries([
      new CapsuleGeometry(0.28, 0.8, 12, 32).translate(-0.3, 0.25, 0),
      new CapsuleGeometry(0.25, 0.7, 12, 32).rotateZ(Math.PI / 2).translate(0.15, -0.55, 0),
    ]),
  boat: () => new BoxGeometry(1.5, 0.35, 0.6, 12, 4, 6),
  goat: () =>
    mergeGeometries([
      new SphereGeometry(0.5, 40, 28).scale(1.2, 0.9, 0.9),
      new TorusGeometry(0.3, 0.07, 16, 40, Math.PI).rotateY(0.7).translate(0.1, 0.45, 0),
      new SphereGeometry(0.2, 32, 24).translate(0.7, -0.1, 0.1),
    ]),
  knot: () => new TorusKnotGeometry(0.6, 0.2, 160, 20),
};

type Point = readonly [x: number, y: number];

/** The lines of outlines, sampled at even steps. */
function linesOf(svg: string): Point[][] {
  return pathsOf(svg, 'outlines').map((data) => {
    const [points] = ringsOf(data);
    const corners = Array.from({ length: points.length / 2 }, (_, i): Point => [points[2 * i], points[2 * i + 1]]);
    if (/z/i.test(data)) corners.push(corners[0]);
    const line: Point[] = [corners[0]];
    for (let i = 1; i < corners.length; i++) {
      const [[ax, ay], [bx, by]] = [corners[i - 1], corners[i]];
      const steps = Math.max(1, Math.round(Math.hypot(bx - ax, by - ay) / STEP));
      for (let k = 1; k <= steps; k++) line.push([ax + (k * (bx - ax)) / steps, ay + (k * (by - ay)) / steps]);
    }
    return line;
  });
}

const lengthOf = (line: readonly Point[]): number =>
  line.slice(1).reduce((sum, [x, y], i) => sum + Math.hypot(x - line[i][0], y - line[i][1]), 0);

const isNear = ([x, y]: Point, places: readonly Point[], distance: number): boolean =>
  places.some(([px, py]) => Math.hypot(px - x, py - y) <= distance);

/** The lengths of stretches of lines where nothing is drawn. */
function gapsIn(lines: readonly Point[][], isDrawn: (place: Point) => boolean): number[] {
  const gaps: number[] = [];
  for (const line of lines) {
    let open = -1;
    for (const [i, place] of [...line, null].entries()) {
      const isOpen = place !== null && !isDrawn(place);
      if (isOpen && open < 0) open = i;
      if (isOpen || open < 0) continue;
      gaps.push(lengthOf(line.slice(open, i)));
      open = -1;
    }
  }
  return gaps;
}

function sizeOf(lines: readonly Point[][]): number {
  const sides = [0, 1].map((k) => {
    const values = lines.flat().map((place) => place[k]);
    return values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
  });
  return Math.max(...sides);
}

async function drawn(model: string, lostEdges: number, kind: 'pen' | 'print'): Promise<string> {
  const mesh = await hatchedMesh(MODELS[model](), { outlines: { lostEdges }, material: BLANK });
  const sheet = { sheet: [SIDE, SIDE], margin: 5 } as const;
  const plan = kind === 'pen' ? { ...sheet, kind, penWidth: PEN } : { ...sheet, kind, leastWidth: 0.2 };
  return (await drawSVG(sceneOf(mesh), cameraAt(0.5, 0.45, 1), plan)).svg;
}

/** Whether a point lies inside filled rings, by the rule `nonzero`. */
const isWithin = ([x, y]: Point, rings: readonly (readonly number[])[]): boolean => {
  let winding = 0;
  for (const ring of rings) {
    for (let i = 0; i < ring.length; i += 2) {
      const next = (i + 2) % ring.length;
      const [x0, y0, x1, y1] = [ring[i], ring[i + 1], ring[next], ring[next + 1]];
      if (y0 <= y === y1 <= y) continue;
      if (x0 + ((y - y0) / (y1 - y0)) * (x1 - x0) > x) winding += y1 > y0 ? 1 : -1;
    }
  }
  return winding !== 0;
};

const quick = (model: string) => ({ tags: model === 'boot' ? [] : ['all'] });

describe('where all lit edges are lost', () => {
  for (const model of Object.keys(MODELS)) {
    test(
      `a pen leaves gaps of limited length in the outline of a ${model}, and no loose piece`,
      quick(model),
      async () => {
        const whole = linesOf(await drawn(model, 0, 'pen'));
        const left = linesOf(await drawn(model, 1, 'pen'));
        const places = left.flat();
        const gaps = gapsIn(whole, (place) => isNear(place, places, 0.15));
        const size = sizeOf(whole);
        // Plus a fifth of a millimetre, the precision of the sampling.
        expect(Math.max(0, ...gaps)).toBeLessThan(0.1 * size + 0.2);
        const sum = (lengths: readonly number[]) => lengths.reduce((a, b) => a + b, 0);
        expect(sum(gaps)).toBeLessThan(sum(whole.map(lengthOf)) / 3);
        // No gap is so short that it would look like an error; it may be shorter where a loose piece was dropped beside it.
        for (const gap of gaps.filter((one) => one > 0.3)) expect(gap).toBeGreaterThan(0.9);
        if (model !== 'boat') expect(gaps.length).toBeGreaterThan(0);
        for (const [i, line] of left.entries()) {
          const others = left.filter((_, k) => k !== i).flat();
          const ends = [line[0], line[line.length - 1]];
          if (!ends.some((end) => isNear(end, others, PEN + STEP))) expect(lengthOf(line)).toBeGreaterThan(2);
        }
      },
    );

    test(`a print leaves the same gaps in the outline of a ${model}`, quick(model), async () => {
      const whole = linesOf(await drawn(model, 0, 'pen'));
      const rings = pathsOf(await drawn(model, 1, 'print'), 'outlines').map(ringsOf);
      const gaps = gapsIn(whole, (place) => rings.some((shape) => isWithin(place, shape))).filter((gap) => gap > 0.3);
      expect(Math.max(0, ...gaps)).toBeLessThan(0.1 * sizeOf(whole) + 0.2);
    });
  }

  test('by default no contour is lost, by pen or in print', async () => {
    const whole = linesOf(await drawn('boot', 0, 'pen'));
    const places = linesOf(await drawn('boot', 0.2, 'pen')).flat();
    expect(gapsIn(whole, (place) => isNear(place, places, 0.15))).toEqual([]);
    const rings = pathsOf(await drawn('boot', 0.2, 'print'), 'outlines').map(ringsOf);
    expect(gapsIn(whole, (place) => rings.some((shape) => isWithin(place, shape))).filter((gap) => gap > 0.3)).toEqual(
      [],
    );
  });
});
