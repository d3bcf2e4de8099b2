import { expect, test } from 'vitest';
import { pullOffsets } from '../../../../../src/mesh/form/phase/PhaseSystem.js';
import { coarsenSeam } from '../../../../../src/mesh/form/phase/phaseLevels.js';
import type { SeamEdges } from '../../../../../src/mesh/form/phase/phaseMatrix.js';
import { noise } from '../../shapes.js';

/** The edges of a cut, each from node to node with a sign and an offset (−1: none) at both ends, and a weight. */
type Edge = [a: number, b: number, signA: number, signB: number, offsetA: number, offsetB: number, weight: number];

const seamOf = (edges: readonly Edge[]): SeamEdges => ({
  nodes: Uint32Array.from(edges.flatMap((edge) => edge.slice(0, 2))),
  signs: Int8Array.from(edges.flatMap((edge) => edge.slice(2, 4))),
  offsets: Int32Array.from(edges.flatMap((edge) => edge.slice(4, 6))),
  weights: Float64Array.from(edges, (edge) => edge[6]),
});

const edgesOf = ({ nodes, signs, offsets, weights }: SeamEdges): number[][] =>
  [...weights].map((weight, i) => [
    ...[nodes, signs, offsets].flatMap((values) => [values[2 * i], values[2 * i + 1]]),
    weight,
  ]);

test('edges between the same cells with the same signs and offsets become one, whichever way they lead', () => {
  const seam = seamOf([
    [0, 2, 1, -1, 0, -1, 1],
    [3, 1, -1, 1, -1, 0, 2],
    [1, 2, 1, -1, 0, 1, 4],
    [1, 2, 1, 1, 0, -1, 8],
  ]);
  expect(edgesOf(coarsenSeam(seam, Uint32Array.of(0, 0, 1, 1)))).toEqual([
    [0, 1, 1, -1, 0, -1, 3],
    [0, 1, 1, -1, 0, 1, 4],
    [0, 1, 1, 1, 0, -1, 8],
  ]);
});

test('an edge whose ends always agree is left out', () => {
  const seam = seamOf([
    [0, 1, 1, 1, 2, 2, 1],
    [0, 1, 1, 1, 2, 3, 1],
    [0, 1, 1, -1, 2, 2, 1],
  ]);
  expect(edgesOf(coarsenSeam(seam, Uint32Array.of(0, 0)))).toEqual([
    [0, 0, 1, 1, 2, 3, 1],
    [0, 0, 1, -1, 2, 2, 1],
  ]);
  expect(edgesOf(coarsenSeam(seamOf([]), Uint32Array.of(0)))).toEqual([]);
});

test('forces on offsets are the same for values that are constant in each cell', () => {
  const random = noise(5);
  const pick = (count: number) => Math.floor(count * (0.5 + 0.4999 * random()));
  const nodes = 60;
  const offsets = 3;
  const ofNode = Uint32Array.from({ length: nodes }, (_, node) => node % 3);
  const edges = Array.from(
    { length: 2000 },
    (): Edge => [
      pick(nodes),
      pick(nodes),
      pick(3) - 1,
      pick(3) - 1,
      pick(offsets + 1) - 1,
      pick(offsets + 1) - 1,
      1 + random(),
    ],
  );
  const seam = seamOf(edges);
  const coarse = coarsenSeam(seam, ofNode);
  expect(coarse.weights.length).toBeLessThan(1000);
  const ofCells = Float64Array.from({ length: 6 }, random);
  const ofNodes = Float64Array.from({ length: 2 * nodes }, (_, i) => ofCells[2 * ofNode[i >> 1] + (i % 2)]);
  const jumps = Float64Array.from({ length: 2 * offsets }, random);
  const [fine, onCells] = [new Float64Array(2 * offsets), new Float64Array(2 * offsets)];
  pullOffsets(seam, ofNodes, jumps, fine);
  pullOffsets(coarse, ofCells, jumps, onCells);
  for (const [i, pull] of fine.entries()) expect(onCells[i]).toBeCloseTo(pull, 9);
});
