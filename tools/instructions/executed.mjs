/**
 * @typedef {import('./compilers/readIntel.mjs').Instruction} Instruction
 */

/**
 * What a listing takes, each instruction as often as its branch runs. A branch is known by the marks in its region of the listing; what a
 * compiler has made of short branches, without a jump, counts as often as what is around it.
 *
 * @param {{ instructions: Instruction[], regions: [number, number][] }} listing
 * @param {ReadonlyMap<number, number>} runs - how often a branch runs, by the bits that mark it; without, everything counts once
 * @returns {{ cost: number, math: number }} without the marks themselves
 */
export function executed({ instructions, regions }, runs = new Map()) {
  const copies = new Map();
  for (const { bits } of instructions) if (bits !== null) copies.set(bits, (copies.get(bits) ?? 0) + 1);
  // Inner regions first: an instruction belongs to the smallest that holds it.
  const sorted = regions
    .toSorted((a, b) => a[1] - a[0] - (b[1] - b[0]))
    .map(([from, to]) => ({ from, to, runs: undefined }));
  const holding = (line) => sorted.filter(({ from, to }) => line >= from && line <= to);
  for (const { line, bits } of instructions) {
    const [inner] = bits === null ? [] : holding(line);
    // Each mark needs the one before, so the first of a region is that of the branch that begins there. A branch that was copied, by a loop that
    // was unrolled or a function that is called twice, runs its share of the times in each copy.
    if (inner && runs.has(bits)) inner.runs ??= runs.get(bits) / copies.get(bits);
  }
  const total = { cost: 0, math: 0 };
  for (const { line, cost, math, bits } of instructions) {
    if (bits !== null) continue;
    const times = holding(line).find((region) => region.runs !== undefined)?.runs ?? 1;
    total.cost += times * cost;
    total.math += times * math;
  }
  return total;
}
