import { Group, Mesh, MeshBasicMaterial } from 'three';
import { expect, test } from 'vitest';
import { HatchingLineMaterial } from '../../../src/lines/HatchingLineMaterial.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { SizeScaler } from '../../../src/scene/SizeScaler.js';

const sceneOf = (...materials: (HatchingMaterial | HatchingLineMaterial | MeshBasicMaterial)[]): Group =>
  new Group().add(...materials.map((material) => new Mesh(undefined, material)));

const sizesOf = ({ lineSpacing, finestSpacing, strokeWidth, texelPixels, toothSize }: HatchingMaterial) => ({
  lineSpacing,
  finestSpacing,
  strokeWidth,
  texelPixels,
  toothSize,
});

test('sizes in pixels are scaled and restored, those on the object stay', () => {
  const onScreen = new HatchingMaterial({ technique: 'engraved', screenConstancy: 1, lineSpacing: 4.5 });
  const between = new HatchingMaterial({ technique: 'engraved', screenConstancy: 0.5, lineSpacing: 4 });
  const onObject = new HatchingMaterial({ technique: 'engraved', lineSpacing: 4.5 });
  const lines = new HatchingLineMaterial({ lineWidth: 2, wobble: 1, tooth: 0.4, contours: 3 });
  const scaler = new SizeScaler();
  scaler.scale(sceneOf(onScreen, between, onObject, lines, new MeshBasicMaterial()), 0.25);
  expect([onScreen.lineSpacing, between.lineSpacing, onObject.lineSpacing]).toEqual([1.125, 2, 4.5]);
  // A lower resolution alone brings lines no farther apart, as long as they can be told apart.
  expect(onScreen.finestSpacing).toBe(2);
  expect([lines.lineWidth, lines.wobble, lines.toothSize, lines.tooth, lines.contours]).toEqual([
    0.5, 0.25, 0.625, 0.4, 3,
  ]);
  onObject.toothSize = 9;
  scaler.restore();
  expect([onScreen.lineSpacing, between.lineSpacing, onObject.lineSpacing]).toEqual([4.5, 4, 4.5]);
  expect([onScreen.finestSpacing, lines.lineWidth, lines.toothSize]).toEqual([3, 2, 2.5]);
  expect(onObject.toothSize).toBe(9);
});

test.each([{ strokeWidth: 3 }, { texelPixels: 3 }, {}])(
  'of two that clear each other the one set remains: %j',
  (look) => {
    const material = new HatchingMaterial(look);
    const before = sizesOf(material);
    const scaler = new SizeScaler();
    scaler.scale(sceneOf(material), 0.5);
    expect(material.strokeWidth).toBe('strokeWidth' in look ? 1.5 : null);
    if (!('strokeWidth' in look)) expect(material.texelPixels).toBe(before.texelPixels / 2);
    scaler.restore();
    expect(sizesOf(material)).toEqual(before);
  },
);
