import { describe, expect, test } from 'vitest';
import type { FreeForces } from '../../../../../src/mesh/form/phase/conjugateGradients.js';
import {
  type LastPart,
  type PhaseSystem,
  type PhaseVector,
  phaseSystem,
  pullOffsets,
} from '../../../../../src/mesh/form/phase/PhaseSystem.js';
import type { PhaseLevel } from '../../../../../src/mesh/form/phase/phaseLevels.js';
import type { SeamEdges } from '../../../../../src/mesh/form/phase/phaseMatrix.js';
import { NO_OFFSET, type SeamRelations } from '../../../../../src/mesh/form/phase/seamRelations.js';
import { roundJumps, roundParts } from '../../../../../src/mesh/form/phase/solvePhase.js';
import { finish } from '../../meshes.js';
import { partOf } from './parts.js';

describe('roundParts', () => {
  /** Jumps of φ and φ₂, one after the other. */
  const rounded = (parts: readonly LastPart[], ...jumps: number[]) => {
    const values = Float64Array.from(jumps);
    roundParts(parts, values, new Uint8Array(values.length));
    return [...values];
  };

  test('to multiples of 4, and of 2 for lines that cross; of two jumps that are held to each other, one up and the other down', () => {
    // Their energy is (x + y)² and a little more.
    const part = partOf([0], [0, 1], [[1], [0, 1], [0, 1, 0.1]]);
    expect(rounded([part], 21.6, 10.8, 5.8, 2.8)).toEqual([24, 12, 4, 2]);
  });

  test('to 2 or 1 where 4 would leave too little', () => {
    const part = partOf([0], [0], [[1], [0, 1]]);
    expect(rounded([part], 1.3, 0.8)).toEqual([1, 1]);
    expect(rounded([part], 2.3, 12.9)).toEqual([2, 12]);
    expect(rounded([part], 9.1, 0.1)).toEqual([8, 0]);
  });
});

describe('roundJumps', () => {
  /** Jumps in a row, each held to the next, and weakly to what it is. */
  function rowOf(jumps: readonly number[]): { system: PhaseSystem; forces: FreeForces; x: PhaseVector } {
    const { length: count } = jumps;
    const places = Int32Array.from(jumps.keys());
    const relations: SeamRelations = {
      signs: new Int8Array(),
      ofWedge: new Int32Array(),
      origins: new Int32Array(count).fill(NO_OFFSET),
      originSigns: new Int8Array(count).fill(1),
      starts: Uint32Array.from({ length: count + 1 }, (_, i) => i),
      segments: Uint32Array.from(places),
      factors: new Float32Array(count).fill(1),
      segmentCount: count,
      jumps: {
        free: Uint32Array.from(places),
        bound: new Uint32Array(),
        starts: Uint32Array.of(0),
        segments: new Uint32Array(),
        factors: new Int8Array(),
      },
    };
    const seam: SeamEdges = {
      nodes: new Uint32Array(4 * count),
      signs: new Int8Array(4 * count).fill(1),
      offsets: Int32Array.from([...places].flatMap((i) => [i, NO_OFFSET, i, i + 1 < count ? i + 1 : i])),
      weights: Float64Array.from([...places].flatMap(() => [1, 100])),
    };
    const level: PhaseLevel = {
      matrix: {
        starts: Uint32Array.of(0, 0),
        neighbours: new Uint32Array(),
        values: new Float64Array(),
        diagonal: Float64Array.of(1),
        walls: new Uint8Array(),
        seam,
      },
      fans: Uint32Array.of(0),
      cells: null,
    };
    const x = { nodes: new Float64Array(2), jumps: Float64Array.from(jumps.flatMap((jump) => [jump, jump / 2])) };
    const forces = { nodes: new Float64Array(2), offsets: new Float64Array(2 * count) };
    pullOffsets(seam, x.nodes, x.jumps, forces.offsets);
    return { system: phaseSystem(relations, [level]), forces, x };
  }

  test('those nearest to their multiples are rounded first, and the others follow, so that none is torn from its neighbours', () => {
    const { system, forces, x } = rowOf(Array.from({ length: 40 }, (_, i) => (i % 2 === 0 ? 5.7 : 6.4)));
    finish(roundJumps(system, forces, x));
    expect([...x.jumps]).toEqual(Array.from({ length: 80 }, (_, i) => (i % 2 === 0 ? 8 : 4)));
  });

  test('a few that are left are rounded to the nearest', () => {
    const { system, forces, x } = rowOf([5.6, 1.2, 13.4]);
    finish(roundJumps(system, forces, x));
    expect([...x.jumps]).toEqual([4, 2, 0, 0, 12, 6]);
  });
});
