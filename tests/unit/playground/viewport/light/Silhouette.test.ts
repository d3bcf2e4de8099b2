import { Box2, BoxGeometry, Vector2, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { Silhouette } from '../../../../../src/playground/overlay/handleGeometry.js';
import { fitCamera } from '../../../../../src/viewer/sceneSetup/framing.js';
import { createCamera } from '../../../../../src/viewer/sceneSetup/LensCamera.js';

const size = { width: 374, height: 720 };
const RADIUS = 26;
const corners = new BoxGeometry(1.4, 1, 0.8).getAttribute('position').array;

/** A box framed on a phone, and where its corners are seen. */
function seen() {
  const camera = createCamera();
  camera.aspect = size.width / size.height;
  camera.updateProjectionMatrix();
  fitCamera(camera, corners, new Vector3(0.6, 0.4, 1), { fill: 0.76 });
  const silhouette = new Silhouette(corners, camera, size);
  const places: Vector2[] = [];
  for (let i = 0; i < corners.length; i += 3) {
    const { x, y } = new Vector3().fromArray(corners, i).project(camera);
    places.push(new Vector2(((1 + x) / 2) * size.width, ((1 - y) / 2) * size.height));
  }
  return { silhouette, places };
}

const anywhere = new Box2(new Vector2(-1e6, -1e6), new Vector2(1e6, 1e6));
const onSheet = new Box2(new Vector2(26, 26), new Vector2(size.width - 26, size.height - 26));

/** Whether all places lie on the other side of a line that a disc does not cross. */
const isBeside = (disc: Vector2, places: Vector2[]): boolean =>
  Array.from({ length: 360 }, (_, degrees) =>
    new Vector2(1, 0).rotateAround(new Vector2(), (degrees * Math.PI) / 180),
  ).some((out) => Math.max(...places.map((place) => place.dot(out))) <= disc.dot(out) - RADIUS + 0.1);

test('a disc on a model goes beside it by the shortest way, not by the one that leaves the sheet', () => {
  const { silhouette, places } = seen();
  const [left, top] = [Math.min(...places.map(({ x }) => x)), Math.min(...places.map(({ y }) => y))];
  // Within the upper left of it, as the light of the page is.
  const disc = new Vector2(left + 20, top + 40);
  const free = silhouette.wayAround(disc, RADIUS, anywhere, 100);
  expect(free.length()).toBeGreaterThan(20);
  const kept = silhouette.wayAround(disc, RADIUS, onSheet, 100);
  expect(onSheet.containsPoint(disc.clone().add(kept))).toBe(true);
  expect(kept.length()).toBeGreaterThanOrEqual(free.length());
  for (const way of [free, kept]) expect(isBeside(disc.clone().add(way), places)).toBe(true);
  expect(isBeside(disc, places)).toBe(false);
});

test('where the sheet is narrow, a disc goes along its edge', () => {
  const { silhouette, places } = seen();
  const left = Math.min(...places.map(({ x }) => x));
  const { y } = places.find(({ x }) => x === left)!;
  const strip = new Box2(new Vector2(left - 10, 26), new Vector2(left + 40, size.height - 26));
  const disc = new Vector2(left + 5, y + 20);
  const straight = disc.clone().add(silhouette.wayAround(disc, RADIUS, anywhere, 300));
  const along = disc.clone().add(silhouette.wayAround(disc, RADIUS, strip, 300));
  expect(strip.containsPoint(straight)).toBe(false);
  expect(strip.containsPoint(along)).toBe(true);
  expect(isBeside(along, places)).toBe(true);
});

test('a disc beside a model stays, and so does one that would have to go far', () => {
  const { silhouette, places } = seen();
  const top = Math.min(...places.map(({ y }) => y));
  expect(silhouette.wayAround(new Vector2(187, top - 27), RADIUS, anywhere, 100).length()).toBe(0);
  expect(silhouette.wayAround(new Vector2(187, 360), RADIUS, anywhere, 60).length()).toBe(0);
  expect(silhouette.wayAround(new Vector2(187, 360), RADIUS, anywhere, 400).length()).toBeGreaterThan(60);
});
