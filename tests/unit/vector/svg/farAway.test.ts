import { BoxGeometry, Group, Plane, PlaneGeometry, PointLight, Scene, SphereGeometry, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh } from '../hatchedScene.js';
import { pathsOf, ringsOf } from '../paths.js';

/** Beyond the range in which single precision has fractions. */
const FAR = new Vector3(2 ** 24, 2 ** 23, -(2 ** 22));

/** A clipped ball in front of a box on a ground, lit by a lamp, with one part in focus, at a place. */
async function drawnAt(place: Vector3) {
  const look = {
    technique: 'engraving',
    composition: { exposure: 1, vignette: 0.4, focusRadius: 0.8 },
    lineSpacing: 9,
  } as const;
  const at = (x: number, y: number, z: number): Vector3 => new Vector3(x, y, z).add(place);
  const [ball, box, ground] = await Promise.all([
    hatchedMesh(new SphereGeometry(0.35, 16, 10), {
      material: { ...look, composition: { ...look.composition, focus: at(0.3, 0, 0.5) } },
    }),
    hatchedMesh(new BoxGeometry(0.8, 0.6, 0.4), { material: look, outlines: { hidden: 'faint' } }),
    hatchedMesh(new PlaneGeometry(1.8, 1.8, 2, 2), { material: look, outlines: false }),
  ]);
  ball.position.set(0.2, 0, 0.5);
  ball.material.clippingPlanes = [new Plane().setFromNormalAndCoplanarPoint(new Vector3(0, -1, 0), at(0, 0.15, 0))];
  ground.rotation.x = -Math.PI / 2;
  ground.position.y = -0.35;
  const lamp = new PointLight('white', 8);
  lamp.position.set(-1, 1.5, 1);
  for (const object of [ball, box, ground, lamp]) object.castShadow = object.receiveShadow = true;
  const holder = new Group().add(ball, box, ground, lamp);
  holder.position.copy(place);
  const camera = cameraAt(0.5, 0.4, 1);
  camera.position.add(place);
  const options = { sheet: [30, 30], margin: 2, kind: 'pen', penWidth: 0.3, order: 'drawn', shadows: 'hard' } as const;
  return drawSVG(new Scene().add(holder), camera, options);
}

test('a scene far from the origin is drawn as it is there: shadows, clipping, focus, hidden lines', async () => {
  const [near, far] = await Promise.all([drawnAt(new Vector3()), drawnAt(FAR)]);
  const numbersOf = (svg: string): number[] => pathsOf(svg).flatMap((path) => ringsOf(path).flat());
  const expected = numbersOf(near.svg);
  expect(expected.length).toBeGreaterThan(500);
  const found = numbersOf(far.svg);
  expect(Math.abs(found.length - expected.length)).toBeLessThan(0.01 * expected.length);
  expect(far.drawn / near.drawn).toBeCloseTo(1, 3);
  expect(far.paths / near.paths).toBeCloseTo(1, 2);
});
