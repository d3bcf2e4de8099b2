import { Box3, Group, PerspectiveCamera, Vector3, type WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import { createEmphasisUniforms, writeEmphasis } from '../../../../src/material/emphasis/emphasis.js';
import { SceneExtent } from '../../../../src/material/emphasis/SceneExtent.js';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import type { HatchingMaterialParameters } from '../../../../src/material/HatchingMaterialParameters.js';

const renderer = { info: { render: { frame: 0 } } } as unknown as WebGLRenderer;

/** A scene between depths of 2 and 12, which is deep. */
const frame = new Group();
const extent = new SceneExtent(frame, new Box3(new Vector3(-0.5, -0.5, -12), new Vector3(0.5, 0.5, -2)));
const camera = new PerspectiveCamera(40);

function fading(parameters: HatchingMaterialParameters): number[] {
  const uniforms = createEmphasisUniforms();
  renderer.info.render.frame++;
  writeEmphasis(new HatchingMaterial(parameters), uniforms, renderer, camera);
  return (uniforms.depthFading.value as Vector3).toArray();
}

test('depth is measured by the scene where it is known, and by the world elsewhere', () => {
  const look = { technique: 'engraved', depthFade: 0.5, depthNear: 0.25, depthFar: 2 } as const;
  expect(fading({ ...look, extent })).toEqual([4.5, 22, 0.5]);
  expect(fading(look)).toEqual([0.25, 2, 0.5]);
});

test('the measure goes with the object that the extent is of', () => {
  frame.position.z = -3;
  frame.updateMatrixWorld();
  expect(fading({ technique: 'engraved', depthFade: 1, extent })).toEqual([5, 15, 1]);
  frame.position.z = 0;
  frame.updateMatrixWorld();
});

test('left to itself, only a deep scene fades', () => {
  expect(fading({ technique: 'anchored', extent })).toEqual([2, 12, 0.7]);
  expect(fading({ technique: 'anchored' })[2]).toBe(0);
  const ball = new SceneExtent(frame, new Box3(new Vector3(-1, -1, -6), new Vector3(1, 1, -4)));
  expect(fading({ technique: 'anchored', extent: ball })[2]).toBe(0);
});

test('a fade whose end lies before its start is an edge', () => {
  const [near, far] = fading({ technique: 'engraved', depthFade: 1, depthNear: 3, depthFar: 1 });
  expect(near).toBe(3);
  expect(far).toBeGreaterThan(near);
});

test.each(['triangle', 'adjacency'] as const)('%s never fades, nor do its outlines', (technique) => {
  const material = new HatchingMaterial({ technique, extent });
  material.depthFade = 1;
  const uniforms = createEmphasisUniforms();
  writeEmphasis(material, uniforms, renderer, camera);
  expect((uniforms.depthFading.value as Vector3).z).toBe(0);
});

test('a copy fades as its original, and JSON keeps what is not at its default', () => {
  const material = new HatchingMaterial({ technique: 'engraved', depthFade: 0.4, extent });
  expect(material.clone()).toMatchObject({ depthFade: 0.4, extent });
  expect(material.toJSON()).toMatchObject({ depthFade: 0.4 });
  material.depthFade = 'auto';
  expect(material.toJSON()).not.toHaveProperty('depthFade');
  expect(() => Object.assign(material, { depthFade: 'deep' })).toThrow(RangeError);
});
