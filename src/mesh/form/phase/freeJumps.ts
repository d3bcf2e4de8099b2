/**
 * Around each regular point of the cut, the jumps of the segments that meet there cancel: Σ ±j = 0. These are the equations of
 * all such points, one after the other. A segment is in at most two of them, or twice in one, because it has two ends.
 */
export interface JumpEquations {
  /** The terms of equation i are starts[i] … starts[i + 1] − 1. */
  starts: number[];
  /** For each term its segment. */
  segments: number[];
  /** For each term 1 or −1. */
  signs: number[];
}

/** Which jumps are free, and how the others depend on them: by whole multiples, so that whole jumps stay whole. */
export interface FreeJumps {
  /** The segments whose jumps are free, in rising order. */
  free: Uint32Array;
  /** The segments whose jumps depend on others, each after those it depends on. */
  bound: Uint32Array;
  /** The terms that bound jump i is the sum of are starts[i] … starts[i + 1] − 1. */
  starts: Uint32Array;
  segments: Uint32Array;
  factors: Int8Array;
}

/** Stands for a missing equation or segment. */
const NONE = -1;

/** Equations as nodes of a graph whose edges are the segments, and a spanning forest of it. */
interface EquationForest {
  /** For each segment the terms it has at its two ends, or NONE: 2·segment and 2·segment + 1. */
  ends: Int32Array;
  /** For each term its equation. */
  equationOf: Int32Array;
  /** The equations, each after its parent. */
  order: number[];
  /** For each equation the term of the segment to its parent, or NONE at a root. */
  parentTerms: Int32Array;
  /** For each equation 1 once it is reached. */
  isReached: Uint8Array;
}

/**
 * Solves the equations in linear time. They are those of currents at the nodes of a graph: along a spanning tree each equation
 * gives the jump towards the root, and all other jumps are free. Trees are rooted where segments end freely, at singular points
 * and borders. In a part of the graph without such an end, the sum of all equations remains. Its terms are ±2j, each of a segment
 * that closes an odd loop, or nothing at all.
 */
export function freeJumps(equations: JumpEquations, segmentCount: number): FreeJumps {
  const forest = plant(equations, segmentCount);
  const { ends, order, equationOf, parentTerms } = forest;
  const rows: { segment: number; terms: [segment: number, factor: number][] }[] = [];
  const isBound = new Uint8Array(segmentCount);
  for (let segment = 0; segment < segmentCount; segment++) {
    const inner = [ends[2 * segment], ends[2 * segment + 1]].filter((term) => term !== NONE);
    if (inner.length !== 1 || forest.isReached[equationOf[inner[0]]] === 1) continue;
    forest.isReached[equationOf[inner[0]]] = 1;
    parentTerms[equationOf[inner[0]]] = inner[0];
    order.push(equationOf[inner[0]]);
  }
  grow(equations, forest, 0);
  for (let root = 0; root < parentTerms.length; root++) {
    if (forest.isReached[root] === 1) continue;
    const first = order.length;
    forest.isReached[root] = 1;
    order.push(root);
    grow(equations, forest, first);
    const terms = remainder(equations, forest, first);
    if (terms.length === 0) continue;
    const [[segment, sign], ...others] = terms;
    rows.push({ segment, terms: others.map(([other, factor]) => [other, -sign * factor]) });
    isBound[segment] = 1;
  }
  for (const equation of order.toReversed()) {
    const parent = parentTerms[equation];
    if (parent === NONE) continue;
    const row = { segment: equations.segments[parent], terms: [] as [number, number][] };
    for (let term = equations.starts[equation]; term < equations.starts[equation + 1]; term++) {
      if (term === parent) continue;
      row.terms.push([equations.segments[term], -equations.signs[parent] * equations.signs[term]]);
    }
    rows.push(row);
    isBound[row.segment] = 1;
  }
  const starts = new Uint32Array(rows.length + 1);
  for (const [i, { terms }] of rows.entries()) starts[i + 1] = starts[i] + terms.length;
  const terms = rows.flatMap((row) => row.terms);
  return {
    free: Uint32Array.from(isBound.keys()).filter((segment) => isBound[segment] === 0),
    bound: Uint32Array.from(rows, ({ segment }) => segment),
    starts,
    segments: Uint32Array.from(terms, ([segment]) => segment),
    factors: Int8Array.from(terms, ([, factor]) => factor),
  };
}

/** The graph without trees. */
function plant({ starts, segments }: JumpEquations, segmentCount: number): EquationForest {
  const equationCount = starts.length - 1;
  const ends = new Int32Array(2 * segmentCount).fill(NONE);
  const equationOf = new Int32Array(segments.length);
  for (let equation = 0; equation < equationCount; equation++) {
    for (let term = starts[equation]; term < starts[equation + 1]; term++) {
      const end = 2 * segments[term];
      ends[ends[end] === NONE ? end : end + 1] = term;
      equationOf[term] = equation;
    }
  }
  return {
    ends,
    equationOf,
    order: [],
    parentTerms: new Int32Array(equationCount).fill(NONE),
    isReached: new Uint8Array(equationCount),
  };
}

/** Reaches everything connected to the equations of `order` from `first` on, breadth first. */
function grow({ starts, segments }: JumpEquations, forest: EquationForest, first: number): void {
  const { ends, equationOf, order, parentTerms, isReached } = forest;
  for (let i = first; i < order.length; i++) {
    for (let term = starts[order[i]]; term < starts[order[i] + 1]; term++) {
      const end = 2 * segments[term];
      const other = ends[end] === term ? ends[end + 1] : ends[end];
      if (other === NONE || isReached[equationOf[other]] === 1) continue;
      isReached[equationOf[other]] = 1;
      parentTerms[equationOf[other]] = other;
      order.push(equationOf[other]);
    }
  }
}

/** The sum of the equations of a tree without free end, in which its tree segments cancel: half of its terms ±2j. */
function remainder(
  { starts, segments, signs }: JumpEquations,
  { ends, equationOf, order, parentTerms }: EquationForest,
  first: number,
): [segment: number, sign: number][] {
  const factors = new Map([[order[first], 1]]);
  for (const equation of order.slice(first + 1)) {
    const term = parentTerms[equation];
    const end = 2 * segments[term];
    const above = ends[end] === term ? ends[end + 1] : ends[end];
    factors.set(equation, -factors.get(equationOf[above])! * signs[above] * signs[term]);
  }
  const sums = new Map<number, number>();
  for (const [equation, factor] of factors) {
    for (let term = starts[equation]; term < starts[equation + 1]; term++) {
      sums.set(segments[term], (sums.get(segments[term]) ?? 0) + factor * signs[term]);
    }
  }
  return [...sums].filter(([, sum]) => sum !== 0).map(([segment, sum]) => [segment, sum / 2]);
}

/** Computes the bound jumps of `jumps`, two values per segment, from the free ones. */
export function bindJumps({ bound, starts, segments, factors }: FreeJumps, jumps: Float64Array): void {
  for (let i = 0; i < bound.length; i++) {
    let sum = 0;
    let sum2 = 0;
    for (let term = starts[i]; term < starts[i + 1]; term++) {
      const segment = 2 * segments[term];
      sum += factors[term] * jumps[segment];
      sum2 += factors[term] * jumps[segment + 1];
    }
    jumps[2 * bound[i]] = sum;
    jumps[2 * bound[i] + 1] = sum2;
  }
}

/** The transpose of `bindJumps`: moves forces on bound jumps to the free ones that they depend on. */
export function releaseJumps({ bound, starts, segments, factors }: FreeJumps, pulls: Float64Array): void {
  for (let i = bound.length - 1; i >= 0; i--) {
    const pull = pulls[2 * bound[i]];
    const pull2 = pulls[2 * bound[i] + 1];
    pulls[2 * bound[i]] = pulls[2 * bound[i] + 1] = 0;
    for (let term = starts[i]; term < starts[i + 1]; term++) {
      const segment = 2 * segments[term];
      pulls[segment] += factors[term] * pull;
      pulls[segment + 1] += factors[term] * pull2;
    }
  }
}
