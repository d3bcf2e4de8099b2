import { BufferAttribute, BufferGeometry, IcosahedronGeometry, PlaneGeometry } from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import { assembleHeatEquation, type HeatLevel } from '../../../../src/mesh/normals/assembleHeatEquation.js';
import { coarsenHeat, diffuse, isFar } from '../../../../src/mesh/normals/diffuse.js';
import { meanNormals } from '../../../../src/mesh/normals/fanNormals.js';
import { sortFans } from '../../../../src/mesh/normals/fans.js';
import { highestRate } from '../../../../src/mesh/normals/heatFlow.js';
import { meshFrom, surfaceOf } from '../features/surfaces.js';
import { finish } from '../meshes.js';

/** The heat equation of a welded geometry, with the places of its nodes. */
function levelOf(geometry: BufferGeometry): HeatLevel & { places: Float32Array } {
  for (const name of ['normal', 'uv']) geometry.deleteAttribute(name);
  const mesh = meshFrom(mergeVertices(geometry));
  const surface = surfaceOf(mesh);
  const cut = { ...surface, twins: surface.sharpTwins };
  const sorted = finish(sortFans(cut));
  const { masses } = finish(meanNormals(surface, sorted));
  const places = new Float32Array(3 * surface.fans.count);
  for (const [corner, vertex] of mesh.indices.entries()) {
    const fan = sorted.numbers[surface.fans.ofCorner[corner]];
    places.set(mesh.positions.subarray(3 * vertex, 3 * vertex + 3), 3 * fan);
  }
  return { heat: finish(assembleHeatEquation(cut, masses, sorted)), places, shares: undefined };
}

const sum = (values: ArrayLike<number>): number => Array.from(values).reduce((total, value) => total + value, 0);

describe('a coarser copy of the heat equation', () => {
  const level = levelOf(new PlaneGeometry(2, 2, 60, 60));
  const coarse = finish(coarsenHeat(level));
  const { starts, neighbours, weights, masses, degrees } = coarse.heat;

  test('has the mass of the finer one, on a small part of its nodes', () => {
    expect(masses.length).toBeLessThan(level.heat.masses.length / 6);
    expect(sum(masses)).toBeCloseTo(4, 5);
  });

  test('lets as much heat flow from one cell to another as back', () => {
    const flows = new Map<string, number>();
    for (let cell = 0; cell < masses.length; cell++) {
      for (let entry = starts[cell]; entry < starts[cell + 1]; entry++)
        flows.set(`${cell} ${neighbours[entry]}`, weights[entry]);
      expect(degrees[cell]).toBeCloseTo(sum(weights.subarray(starts[cell], starts[cell + 1])), 5);
    }
    for (const [pair, weight] of flows) expect(flows.get(pair.split(' ').reverse().join(' '))).toBeCloseTo(weight, 6);
    expect(flows.size).toBe(weights.length);
  });

  test('spreads heat equally fast: the Dirichlet energy of x and of y is the area', () => {
    for (const axis of [0, 1]) {
      let energy = 0;
      for (let cell = 0; cell < masses.length; cell++) {
        for (let entry = starts[cell]; entry < starts[cell + 1]; entry++)
          energy +=
            (weights[entry] / 2) * (coarse.places[3 * cell + axis] - coarse.places[3 * neighbours[entry] + axis]) ** 2;
      }
      // Cells with oblique neighbours add a little.
      expect(energy).toBeGreaterThan(3.6);
      expect(energy).toBeLessThan(5.5);
    }
  });
});

test('heat that spreads far through coarser copies gives the same result', { tags: ['all'] }, () => {
  const geometry = () => new IcosahedronGeometry(1, 60);
  const start = levelOf(geometry());
  const rate = highestRate(start.heat);
  const time = 0.3 ** 2 / 4;
  expect(isFar(time * rate)).toBe(true);
  const values = () => Float32Array.from(start.places, (value) => Math.sin(9 * value));
  const [coarsely] = finish(diffuse(start, values(), [time]));
  const [finely] = finish(diffuse({ ...levelOf(geometry()), places: undefined }, values(), [time]));
  const error = Math.sqrt(
    sum(coarsely.map((value, i) => (value - finely[i]) ** 2)) / sum(finely.map((value) => value ** 2)),
  );
  expect(error).toBeLessThan(0.05);
  // The pattern is not flat, so a copy that lost it would fail.
  expect(Math.max(...finely)).toBeGreaterThan(0.1);
});

test('heat stays within a disconnected part of the surface', { tags: ['all'] }, () => {
  const one = new IcosahedronGeometry(1, 40);
  const other = one.clone().translate(2.001, 0, 0);
  const both = new BufferGeometry();
  const corners = [one, other].flatMap(({ attributes }) => Array.from(attributes.position.array));
  both.setAttribute('position', new BufferAttribute(new Float32Array(corners), 3));
  const level = levelOf(both);
  const isFirst = (i: number): boolean => level.places[i - (i % 3)] < 1.0004;
  const values = Float32Array.from(level.places, (_, i) => (isFirst(i) ? 1 : -1));
  const [result] = finish(diffuse(level, values, [4]));
  for (const [i, value] of result.entries()) expect(value).toBeCloseTo(isFirst(i) ? 1 : -1, 4);
});
