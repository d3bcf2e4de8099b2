import { conjugateGradients, type Patience } from './conjugateGradients.js';
import { gatherJumps, type PhaseSystem, type PhaseVector } from './PhaseSystem.js';

/** What drives the nodes and the offsets of a level. */
export interface FreeForces {
  nodes: Float64Array;
  offsets: Float64Array;
}

/** Solves for nodes and jumps, except for jumps that are held. */
export function* solveFree(
  system: PhaseSystem,
  forces: FreeForces,
  x: PhaseVector,
  patience: Patience,
): Generator<number, void, void> {
  const jumps = new Float64Array(x.jumps.length);
  system.seamBuffers.pulls.set(forces.offsets);
  gatherJumps(system, jumps);
  yield* conjugateGradients(system, { nodes: forces.nodes, jumps }, x, patience);
}
