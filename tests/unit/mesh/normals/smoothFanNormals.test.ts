import { IcosahedronGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { smoothFanNormals } from '../../../../src/mesh/normals/smoothFanNormals.js';
import { meshFrom, surfaceOf } from '../features/surfaces.js';
import { finish } from '../meshes.js';

describe('several radii at once', () => {
  const surface = surfaceOf(meshFrom(new IcosahedronGeometry(1, 12)));
  const smooth = (...radii: number[]) => finish(smoothFanNormals({ ...surface, twins: surface.sharpTwins }, radii));

  test.each([
    ['of one flow', [0.3, 0.1, 0.15]],
    ['of which one is 0', [0, 0.2]],
    ['of which one takes more passes than there may be', [4.5, 0.1]],
    ['the same twice', [0.2, 0.2]],
  ])('%s give what each gives alone, to the last bit', (_, radii) => {
    const together = smooth(...radii);
    expect(together).toEqual(radii.flatMap((radius) => smooth(radius)));
    expect(new Set(radii.map((_, i) => together[i].join())).size).toBe(new Set(radii).size);
  });
});
