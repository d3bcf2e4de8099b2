import { BufferGeometry } from 'three';
import { expect, test, vi } from 'vitest';
import { noteFormAngle, watchFormAngle } from '../../../../src/material/geometry/formAngles.js';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';

test('each new angle is reported once, for the watched material alone', () => {
  const [geometry, material, other] = [new BufferGeometry(), new HatchingMaterial(), new HatchingMaterial()];
  const onOther = vi.fn();
  watchFormAngle(geometry, material, material.crossAngle, onOther);
  noteFormAngle(geometry, material);
  other.crossAngle = 1;
  noteFormAngle(geometry, other);
  noteFormAngle(new BufferGeometry(), other);
  expect(onOther).not.toHaveBeenCalled();
  for (const angle of [1.2, 1.2, 1.3]) {
    material.crossAngle = angle;
    noteFormAngle(geometry, material);
  }
  expect(onOther.mock.calls).toEqual([[1.2], [1.3]]);
});
