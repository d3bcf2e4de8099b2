import { PlaneGeometry } from 'three';
import { expect, test } from 'vitest';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';

const PICTURE = 'data:image/png;base64,iVBORw0KGgo=';

test('a picture lies below the lines, where the camera sees it', async () => {
  const mesh = await hatchedMesh(new PlaneGeometry(1, 1));
  const { svg } = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1), { sheet: [120, 200], margin: 10, picture: PICTURE });
  // The camera's picture is a square of 100 mm in the middle.
  expect(svg).toContain(`<image x="10" y="50" width="100" height="100" preserveAspectRatio="none" href="${PICTURE}"/>`);
  expect(svg.indexOf('<image')).toBeLessThan(svg.indexOf('1 outlines'));
});

test.each([
  [{ picture: 'drawing.png' }, /picture must be a data URL/],
  [{ picture: 'data:image/png;base64,"/><script>' }, /picture must be a data URL/],
  [{ picture: PICTURE, kind: 'pen' as const }, /picture is only for kind: 'print'/],
])('%o is refused in a sentence', async (options, message) => {
  const mesh = await hatchedMesh(new PlaneGeometry(1, 1));
  await expect(drawSVG(sceneOf(mesh), cameraAt(0, 0, 1), options)).rejects.toThrow(message);
});
