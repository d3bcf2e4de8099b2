import type { LastPart } from '../../../../../src/mesh/form/phase/PhaseSystem.js';

/** A part whose factor L has these rows. */
export const partOf = (nodes: number[], jumps: number[], rows: readonly (readonly number[])[]): LastPart => ({
  nodes,
  jumps,
  factor: new Float64Array(rows.flatMap((row) => rows.map((_, column) => row[column] ?? 0))),
  inverses: new Float64Array(rows.map((row, i) => 1 / row[i])),
});
