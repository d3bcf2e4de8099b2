import { Matrix4, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { shadowReach } from '../../../../src/scene/lighting/chooseLight.js';
import { OuterPoints } from '../../../../src/scene/lighting/readTriangles.js';
import { shadowOnGround } from '../../../../src/viewer/sceneSetup/groundShadow.js';

const TOP = [0, 1, 0] as const;
const toward = (x: number, y: number, z: number): [number, number, number] =>
  new Vector3(x, y, z).normalize().toArray();

/** The matrix to the sheet of a camera that looks at the origin. */
function sheetOf(camera: OrthographicCamera | PerspectiveCamera, from: readonly [number, number, number]): number[] {
  camera.position.set(...from);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  camera.updateProjectionMatrix();
  return new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
}

describe('the reach of a shadow', () => {
  const post = [0, 0, 0, 0, 1, 0];
  const fromFront = sheetOf(new OrthographicCamera(-2, 2, 2, -2, 0, 20), [0, 0, 5]);
  const fromAbove = sheetOf(new OrthographicCamera(-2, 2, 2, -2, 0, 20), [0, 5, 1e-6]);

  test.each([
    // The shadow is as long as the post is high, to the right: half way to the edge.
    [toward(-1, 1, 0), fromFront, 0.5],
    // Four times as long.
    [toward(-4, 1, 0), fromFront, 2],
    // Away from the eye: not visible from the front, where the post itself reaches half way up.
    [toward(0, 1, 3), fromFront, 0],
    [toward(0, 1, 3), fromAbove, 1.5],
    [toward(-3, 2, -4), fromAbove, 1],
  ])('of a post under a light at %j', (light, toSheet, reach) => {
    expect(shadowReach({ points: post, top: TOP, toSheet }, light)).toBeCloseTo(reach, 5);
  });

  test('is infinite for a light at or below the horizon, and behind the eye', () => {
    for (const light of [toward(1, 0, 0), toward(1, -0.2, 0)]) {
      expect(shadowReach({ points: post, top: TOP, toSheet: fromFront }, light)).toBe(Infinity);
    }
    const near = sheetOf(new PerspectiveCamera(40, 1, 0.1, 50), [0, 0.5, 3]);
    expect(shadowReach({ points: post, top: TOP, toSheet: near }, toward(0, 1, -4))).toBe(Infinity);
  });

  test('depends on the light, the ground and the sheet, and not on where the world has its origin', () => {
    const toSheet = sheetOf(new OrthographicCamera(-2, 2, 2, -2, 0, 20), [0, 0, 5]);
    const higher = post.map((value, i) => (i % 3 === 1 ? value + 1 : value));
    const light = toward(-1, 1, 0);
    expect(shadowReach({ points: higher, top: TOP, toSheet }, light)).toBeCloseTo(0.5, 5);
    expect(shadowReach({ points: [0, 0, 0, 1, 0, 0], top: [1, 0, 0], toSheet }, toward(1, 1, 0))).toBeCloseTo(0.5, 5);
  });
});

test('26 outer points give the reach of thousands within 5 %, and never more than it', () => {
  const points: number[] = [];
  const outer = new OuterPoints();
  for (let i = 0; i < 4000; i++) {
    const [a, b] = [i * 2.399963, Math.acos(1 - (2 * i + 1) / 4000)];
    const point = [0.9 * Math.sin(b) * Math.cos(a), Math.cos(b), 0.6 * Math.sin(b) * Math.sin(a)];
    points.push(...point);
  }
  outer.addAll([Number.NaN, 0, 0]);
  expect(outer.xyz).toHaveLength(0);
  outer.addAll(points);
  const toSheet = sheetOf(new PerspectiveCamera(26, 1.2, 0.1, 50), [2, 1.5, 5]);
  for (const light of [toward(-2, 2, 2), toward(2, 1.5, 2), toward(-0.5, 1, 3)]) {
    const ground = Math.min(...points.filter((_, i) => i % 3 === 1));
    const shadow = shadowOnGround(points, new Vector3(...light), true, ground);
    let reach = 0;
    for (let i = 0; i < shadow.length; i += 3) {
      const { x, y } = new Vector3().fromArray(shadow, i).applyMatrix4(new Matrix4().fromArray(toSheet));
      reach = Math.max(reach, Math.abs(x), Math.abs(y));
    }
    const found = shadowReach({ points: outer.xyz, top: TOP, toSheet }, light);
    expect(found).toBeLessThan(reach + 1e-3);
    expect(found).toBeGreaterThan(0.95 * reach);
  }
});
