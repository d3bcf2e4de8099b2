import { BoxGeometry, type BufferGeometry, SphereGeometry, TorusGeometry } from 'three';
import { expect, test } from 'vitest';
import { cases } from '../../selection.mjs';
import { cameraAt, hatchedMesh, sceneOf } from './hatchedScene.js';
import { wronglySeen } from './wronglySeen.js';

/** Bodies in front of one another and bodies that intersect. */
const BODIES: Record<string, () => BufferGeometry[]> = {
  torus: () => [new TorusGeometry(0.7, 0.3, 24, 48)],
  'ball, ring and box that run into one another': () => [
    new SphereGeometry(0.7, 48, 32),
    new TorusGeometry(0.75, 0.2, 24, 48).rotateX(0.9),
    new BoxGeometry(0.5, 1.9, 0.5).rotateZ(0.6).rotateX(0.4),
  ],
  'a ball behind bars': () => [
    new SphereGeometry(0.7, 48, 32),
    ...Array.from({ length: 12 }, (_, i) => new BoxGeometry(0.01, 1.6, 0.01).translate(-0.8 + i / 7, 0, 0.9)),
  ],
};

const all = Object.keys(BODIES).flatMap((name) => [[name, false] as const, [name, true] as const]);

test.each(
  cases(
    all.filter((_, i) => i % 3 === 2),
    all,
  ),
)(
  'engraved lines are hidden where a triangle lies before them: %s, orthographic: %s',
  { tags: ['more'] },
  async (name, isOrthographic) => {
    const samples = cases(800, 8000);
    const meshes = await Promise.all(BODIES[name]().map((body) => hatchedMesh(body, { outlines: false })));
    const { visible, hidden, pieces } = wronglySeen(sceneOf(...meshes), cameraAt(0.4, 1, 2.8, isOrthographic), samples);
    expect(pieces).toBeGreaterThan(1500);
    expect(visible).toBeLessThanOrEqual(0.0005);
    expect(hidden).toBeLessThanOrEqual(0.0005);
  },
);
