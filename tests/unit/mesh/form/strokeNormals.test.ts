import { TorusGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { strokeNormals } from '../../../../src/mesh/form/FormSurface.js';
import { meshFrom } from '../features/surfaces.js';
import { finish } from '../meshes.js';
import { frontOf, twinsOf } from './fronts.js';

/** The mean length of the smoothed normals of a torus of radius 1. On a tube of radius ρ it is e^(−r²/4ρ²) for the radius r. */
function meanLength(tube: number, radius: number, share = 1): number {
  const mesh = meshFrom(new TorusGeometry(1, tube, 24, Math.round(24 / tube)));
  const { adjacency, whole } = twinsOf(mesh);
  const { fans } = frontOf(mesh).surface;
  const surface = { mesh, ...adjacency, twins: whole, fans };
  const vectors = finish(strokeNormals(surface, radius, new Float32Array(fans.count).fill(share)));
  let sum = 0;
  for (let i = 0; i < vectors.length; i += 3) sum += Math.hypot(...vectors.subarray(i, i + 3));
  return sum / fans.count;
}

const onTube = (tube: number, radius: number) => Math.exp(-(radius ** 2) / (4 * tube ** 2));

describe('normals are smoothed', () => {
  test('over the whole radius on a thick tube', () => {
    expect(meanLength(0.12, 0.08)).toBeCloseTo(onTube(0.12, 0.08), 1);
    expect(meanLength(0.12, 0.08)).toBeLessThan(onTube(0.12, 0.04));
  });

  test('over half of it on a thin one, and over a quarter on one that is thinner still', () => {
    expect(meanLength(0.03, 0.08)).toBeCloseTo(onTube(0.03, 0.04), 1);
    expect(meanLength(0.015, 0.08)).toBeCloseTo(onTube(0.015, 0.02), 1);
  });

  test('over a share of it on a part that is smaller', () => {
    expect(meanLength(0.12, 0.16, 0.5)).toBeCloseTo(onTube(0.12, 0.08), 1);
  });
});
