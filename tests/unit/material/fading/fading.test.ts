import { Box3, Group, PerspectiveCamera, Vector3, Vector4, type WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import type { HatchingMaterialParameters } from '../../../../src/material/checkValues.js';
import {
  createFadingUniforms,
  takesWeight,
  writeFading,
  writeImportance,
} from '../../../../src/material/fading/fading.js';
import { SceneExtent } from '../../../../src/material/fading/SceneExtent.js';
import { HatchingComposition } from '../../../../src/material/groups/HatchingComposition.js';
import type { HatchingCompositionOptions } from '../../../../src/material/groups/ownedProperties.js';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { writeSheet } from '../../../../src/material/pictureOffset.js';

const renderer = { info: { render: { frame: 0 } } } as unknown as WebGLRenderer;

/** A deep scene, between depths of 2 and 12. */
const frame = new Group();
const extent = new SceneExtent(frame, new Box3(new Vector3(-0.5, -0.5, -12), new Vector3(0.5, 0.5, -2)));
const camera = new PerspectiveCamera(40);

function fading(parameters: HatchingMaterialParameters): number[] {
  const uniforms = createFadingUniforms();
  renderer.info.render.frame++;
  writeFading(new HatchingMaterial(parameters), uniforms, renderer, camera);
  return (uniforms.depthFading.value as Vector3).toArray();
}

// Its code is not fetched after the tests have ended.
await HatchingMaterial.preload();

/** A composition of a scene of this extent. */
const within = (extent: SceneExtent, values: Partial<HatchingCompositionOptions> = {}): HatchingComposition =>
  Object.assign(new HatchingComposition(values), { extent });

test('depth is measured by the scene where it is known, and by the world elsewhere', () => {
  const look = { depthFade: 0.5, depthFadeStart: 0.25, depthFadeEnd: 2 } as const;
  expect(fading({ technique: 'engraving', composition: within(extent, look) })).toEqual([4.5, 22, 0.5]);
  expect(fading({ technique: 'engraving', composition: look })).toEqual([0.25, 2, 0.5]);
});

test('the measure goes with the object that the extent is of', () => {
  frame.position.z = -3;
  frame.updateMatrixWorld();
  expect(fading({ technique: 'engraving', composition: within(extent, { depthFade: 1 }) })).toEqual([5, 15, 1]);
  frame.position.z = 0;
  frame.updateMatrixWorld();
});

test('left to itself, only a deep scene fades', () => {
  expect(fading({ technique: 'hatching', composition: within(extent) })).toEqual([2, 12, 0.7]);
  expect(fading({ technique: 'hatching' })[2]).toBe(0);
  const ball = new SceneExtent(frame, new Box3(new Vector3(-1, -1, -6), new Vector3(1, 1, -4)));
  expect(fading({ technique: 'hatching', composition: within(ball) })[2]).toBe(0);
});

test('a fade whose end lies before its start is an edge', () => {
  const [near, far] = fading({
    technique: 'engraving',
    composition: { depthFade: 1, depthFadeStart: 3, depthFadeEnd: 1 },
  });
  expect(near).toBe(3);
  expect(far).toBeGreaterThan(near);
});

test.each(['triangle', 'adjacency'] as const)('%s never fades, nor do its outlines', (technique) => {
  const material = new HatchingMaterial({ technique, composition: within(extent) });
  material.composition.depthFade = 1;
  const uniforms = createFadingUniforms();
  writeFading(material, uniforms, renderer, camera);
  expect((uniforms.depthFading.value as Vector3).z).toBe(0);
});

test('a copy fades as its original, and JSON keeps what is not at its default', () => {
  const material = new HatchingMaterial({ technique: 'engraving', composition: within(extent, { depthFade: 0.4 }) });
  expect(material.clone().composition).toBe(material.composition);
  expect(material.composition.clone()).toMatchObject({ depthFade: 0.4, extent });
  expect(material.toJSON()).toMatchObject({ composition: { depthFade: 0.4 } });
  material.composition.depthFade = 'auto';
  expect(material.toJSON()).not.toHaveProperty('composition');
  expect(() => Object.assign(material.composition, { depthFade: 'deep' })).toThrow(RangeError);
});

test('the focus is handed over as the camera sees it, and none without a point', () => {
  const uniforms = createFadingUniforms();
  const eye = new PerspectiveCamera();
  eye.position.set(0, 0, 5);
  eye.updateMatrixWorld();
  const material = new HatchingMaterial({
    technique: 'engraving',
    composition: { focus: [1, 2, 3], focusRadius: 0.5 },
  });
  writeFading(material, uniforms, renderer, eye);
  expect(uniforms.focusing.value.toArray()).toEqual([1, 2, -2, 0.5]);
  material.composition.focus = null;
  writeFading(material, uniforms, renderer, eye);
  expect(uniforms.focusing.value.w).toBe(0);
});

test.each([[1, 2], [1, Number.NaN, 3], 'centre', { x: 1, y: 2, z: 3 }])('%j is no point', (focus) => {
  expect(() => new HatchingMaterial({ composition: { focus: focus as never } })).toThrow(
    /HatchingComposition.focus: expected null, a THREE.Vector3/,
  );
  expect(() => Object.assign(new HatchingComposition(), { focus })).toThrow(TypeError);
});

test('a copy of a composition has a point of its own', () => {
  const material = new HatchingMaterial({ composition: { focus: new Vector3(1, 2, 3) } });
  const copy = material.composition.clone();
  material.composition.focus!.x = 7;
  expect(copy.focus!.toArray()).toEqual([1, 2, 3]);
});

test('the sheet of a picture in tiles is the whole picture', () => {
  const uniforms = createFadingUniforms();
  const eye = new PerspectiveCamera();
  writeSheet(uniforms.sheet.value, eye, new Vector4(10, 20, 300, 200));
  expect(uniforms.sheet.value.toArray()).toEqual([10, 20, 300, 200]);
  // The lower right tile of four by two, drawn at twice its size.
  eye.setViewOffset(400, 200, 300, 100, 100, 100);
  writeSheet(uniforms.sheet.value, eye, new Vector4(0, 0, 200, 200));
  expect(uniforms.sheet.value.toArray()).toEqual([-600, 0, 800, 400]);
});

test('three.js is told to upload another importance, and not the same again', () => {
  const uniforms = createFadingUniforms();
  const object = new Group();
  const isOther = (technique: HatchingMaterial['technique']) =>
    writeImportance(object, takesWeight(new HatchingMaterial({ technique })), uniforms);
  expect(isOther('engraving')).toBe(false);
  object.userData.hatching = { importance: 0.25 };
  expect(isOther('engraving')).toBe(true);
  expect(isOther('engraving')).toBe(false);
  expect(uniforms.importance.value).toBe(0.25);
  expect(isOther('triangle')).toBe(true);
  expect(uniforms.importance.value).toBe(1);
});
