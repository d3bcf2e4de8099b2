import { PerspectiveCamera, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { fadeOnSheet, type GroundLight, type SheetPart } from '../../../src/staging/fadeOnSheet.js';

const GROUND = -1;
/** A post in the middle, from the ground up. */
const POST = Array.from({ length: 1401 }, (_, i) => [0, GROUND + i / 700, 0]).flat();

const sunAt = (elevation: number): GroundLight => {
  const angle = (elevation * Math.PI) / 180;
  return { position: new Vector3(Math.cos(angle), Math.sin(angle), 0), isSun: true, widthAt: () => 2.1 };
};

function cameraOf(aspect: number): PerspectiveCamera {
  const camera = new PerspectiveCamera(26, aspect, 0.05, 100);
  camera.position.set(0, 1.5, 6);
  camera.lookAt(0, 0, 0);
  return camera;
}

/** Where on the sheet the shadow of the post ends: 1 is at its edge. */
function endOf(fade: number, elevation: number, camera: PerspectiveCamera, [wide]: SheetPart): number {
  const length = Math.min(2.1 / fade, 2 / Math.sin((elevation * Math.PI) / 180));
  const end = new Vector3(-length * Math.cos((elevation * Math.PI) / 180), GROUND, 0).project(camera);
  return Math.abs(end.x) / wide;
}

test.each([
  ['a phone', 0.46, [1, 1]],
  ['a wide page', 1.6, [1, 1]],
  ['a sheet on it', 1.6, [0.4, 0.9]],
] as const)('a shadow ends before the edges of %s, however low the light', (_, aspect, part) => {
  const camera = cameraOf(aspect);
  let [faded, before] = [0, 0];
  for (let elevation = 80; elevation > 2; elevation -= 0.25) {
    const fade = fadeOnSheet(POST, GROUND, sunAt(elevation), camera, part);
    // A slowly sinking light changes it slowly.
    expect(Math.abs(fade - before)).toBeLessThan(0.35);
    before = fade;
    if (fade === 0) continue;
    faded++;
    expect(endOf(fade, elevation, camera, part)).toBeLessThan(1);
  }
  expect(faded).toBeGreaterThan(20);
});

test('a shadow that lies on the sheet, or is cast by what does not, fades as it likes', () => {
  const camera = cameraOf(1);
  expect(fadeOnSheet(POST, GROUND, sunAt(70), camera, [1, 1])).toBe(0);
  const beside = POST.map((value, i) => (i % 3 === 0 ? value - 5 : value));
  expect(fadeOnSheet(beside, GROUND, sunAt(20), camera, [1, 1])).toBe(0);
  expect(fadeOnSheet([], GROUND, sunAt(20), camera, [1, 1])).toBe(0);
});

test('what is left of a shadow at its caster is never lost', () => {
  const camera = cameraOf(1);
  // It stands at the very edge.
  const slope = 6 * Math.tan((13 * Math.PI) / 180);
  const atEdge = POST.map((value, i) => (i % 3 === 0 ? value - 0.97 * slope : value));
  expect(fadeOnSheet(atEdge, GROUND, sunAt(30), camera, [1, 1])).toBeLessThanOrEqual(6);
});
