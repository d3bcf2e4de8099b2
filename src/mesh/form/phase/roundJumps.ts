import { type FreeForces, solveFree } from './conjugateGradients.js';
import type { LastPart, PhaseSystem, PhaseVector } from './PhaseSystem.js';

/**
 * Jumps of φ are multiples of four, those of φ₂ of two, so that every fourth line, and every second of those that cross, continues across
 * the cut: no more are left where an object is small. Larger multiples would bend lines, most of all along thin limbs, around which φ₂
 * rises by little.
 */
export const MULTIPLES = [4, 2] as const;

/** Largest share of its energy that rounding may add to a part; otherwise its jumps are rounded to smaller multiples. */
const MOST_MOVED = 0.2;

/** The share of the jumps rounded in each turn. The last few are rounded together. */
const SHARE_OF_TURN = 0.5;
const LAST_TURN = 16;

/** Stopping criteria for the unknowns that follow rounded jumps: they need not move far. */
const FOLLOWING = { tolerance: 1e-2, steps: 20 };

/**
 * Rounds the jumps of a solution to the multiples of their family, in place. Parts with a direct solver are rounded there. All other jumps
 * take turns: the half nearest to its multiples is rounded, and the rest is solved again before the next half is. The families are
 * independent.
 */
export function* roundJumps(system: PhaseSystem, forces: FreeForces, x: PhaseVector): Generator<number, void, void> {
  const held = new Uint8Array(x.jumps.length);
  roundParts(system.lastParts, x.jumps, held);
  while (roundNearest(x.jumps, held) > 0) yield* solveFree({ ...system, held }, forces, x, FOLLOWING);
}

/** Rounds the jumps of each family that are nearest to their multiples. Returns the number of those left. */
function roundNearest(jumps: Float64Array, held: Uint8Array): number {
  let left = 0;
  for (const [family, multiple] of MULTIPLES.entries()) {
    const loose = [...held.keys()].filter((i) => i % 2 === family && held[i] === 0);
    const distances = jumps.map((jump) => Math.abs(jump - roundTo(multiple, jump)));
    loose.sort((i, j) => distances[i] - distances[j] || i - j);
    const count = loose.length <= LAST_TURN ? loose.length : Math.ceil(SHARE_OF_TURN * loose.length);
    for (const i of loose.slice(0, count)) {
      jumps[i] = roundTo(multiple, jumps[i]);
      held[i] = 1;
    }
    left += loose.length - count;
  }
  return left;
}

/**
 * Rounds the jumps of parts to the multiples of their family, in place; those of a part that is too small for that to smaller multiples.
 *
 * @param held for each value of a jump 1 if it is rounded; those of the parts are set
 */
export function roundParts(parts: readonly LastPart[], jumps: Float64Array, held: Uint8Array): void {
  for (const part of parts) {
    for (const [family, multiple] of MULTIPLES.entries()) {
      const places = part.jumps.map((jump) => 2 * jump + family);
      const given = places.map((place) => jumps[place]);
      for (const [i, value] of roundedPart(part, given, multiple).entries()) {
        jumps[places[i]] = value;
        held[places[i]] = 1;
      }
    }
  }
}

const roundTo = (multiple: number, jump: number): number => multiple * Math.round(jump / multiple);

/** The jumps of a part, rounded to `multiple`, or to a smaller power of two if little would be left of them. */
function roundedPart(part: LastPart, given: readonly number[], multiple: number): number[] {
  const rounded = nearestPlane(part, given, multiple);
  const moves = rounded.map((value, i) => value - given[i]);
  const isFar = jumpEnergy(part, moves) > MOST_MOVED * jumpEnergy(part, given);
  return multiple > 1 && isFar ? roundedPart(part, given, multiple / 2) : rounded;
}

/**
 * Rounds dependent jumps: where one has been rounded up, the next follows it before it is rounded. This is Babai's nearest plane, for the
 * energy of the jumps after all nodes have been eliminated (the last rows of L).
 */
function nearestPlane(part: LastPart, given: readonly number[], multiple: number): number[] {
  const rounded = given.slice();
  const moves = given.map(() => 0);
  for (let i = given.length - 1; i >= 0; i--) {
    rounded[i] = roundTo(multiple, given[i] - jumpForce(part, moves, i) * part.inverses[part.nodes.length + i]);
    moves[i] = rounded[i] - given[i];
  }
  return rounded;
}

const jumpEnergy = (part: LastPart, jumps: readonly number[]): number =>
  jumps.reduce((sum, _, i) => sum + jumpForce(part, jumps, i) ** 2, 0);

/** Entry i of Lᵀ·jumps, in the last rows of L. */
function jumpForce({ factor, nodes, jumps: { length } }: LastPart, jumps: readonly number[], i: number): number {
  const first = nodes.length;
  const size = first + length;
  let sum = 0;
  for (let k = i; k < length; k++) sum += factor[size * (first + k) + first + i] * jumps[k];
  return sum;
}
