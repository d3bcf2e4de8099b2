/** A line of pixels between two junctions or free ends. */
export interface Branch {
  /** x0, y0, x1, y1, … in pixels, from its start to its end. */
  points: number[];
  /** The distance to paper at each point, in pixels. */
  radii: number[];
  /** The junction at its start, or −1 for a free end. */
  from: number;
  /** The junction at its end, or −1 for a free end. */
  to: number;
}

/** Where three or more branches meet. */
export interface Junction {
  x: number;
  y: number;
  /** The distance to paper, in pixels. */
  radius: number;
}

/** Thinned ink as lines and their junctions. */
export interface SkeletonGraph {
  branches: Branch[];
  nodes: Junction[];
}

/** Pixels between two yields. */
const PIXELS_PER_SLICE = 1 << 14;
/** Owner of a pixel that belongs to no junction. */
const NO_NODE = -1;

/**
 * Follows thinned ink from pixel to pixel.
 *
 * @param skeleton the mask of the lines, in which every pixel inside a line has two neighbours; cleared on the way
 * @param pixels its pixels
 * @param distances the distance of every pixel to paper
 */
export function* traceGraph(
  skeleton: Uint8Array,
  pixels: Int32Array,
  distances: Float32Array,
  width: number,
): Generator<number, SkeletonGraph, void> {
  const around = [-width, 1, width, -1, 1 - width, width + 1, width - 1, -width - 1];
  const tracer: Tracer = { skeleton, distances, width, around, owners: new Map(), branches: [] };
  const nodes = findNodes(tracer, pixels);
  let done = 0;
  for (const [pixel, node] of tracer.owners) {
    for (const step of around) {
      const next = pixel + step;
      if (skeleton[next] && !tracer.owners.has(next)) follow(tracer, next, node, pixel);
    }
    if (++done % PIXELS_PER_SLICE === 0) yield 0.5;
  }
  for (const isLoop of [false, true]) {
    done = 0;
    for (const pixel of pixels) {
      if (++done % PIXELS_PER_SLICE === 0) yield 0.5;
      if (!skeleton[pixel] || tracer.owners.has(pixel)) continue;
      if (isLoop || countNeighbours(tracer, pixel) <= 1) follow(tracer, pixel, NO_NODE, -1);
    }
  }
  return { branches: tracer.branches, nodes };
}

interface Tracer {
  skeleton: Uint8Array;
  distances: Float32Array;
  width: number;
  around: readonly number[];
  /** The node that each pixel of a junction belongs to. */
  owners: Map<number, number>;
  branches: Branch[];
}

function countNeighbours({ skeleton, around }: Tracer, pixel: number): number {
  let count = 0;
  for (const step of around) count += skeleton[pixel + step];
  return count;
}

/** Finds junctions: groups of touching pixels with three neighbours or more. */
function findNodes(tracer: Tracer, pixels: Int32Array): Junction[] {
  const { owners, distances, width, around } = tracer;
  const meeting = new Set<number>();
  for (const pixel of pixels) if (countNeighbours(tracer, pixel) > 2) meeting.add(pixel);
  const nodes: Junction[] = [];
  for (const first of meeting) {
    if (owners.has(first)) continue;
    const members = [first];
    owners.set(first, nodes.length);
    for (const pixel of members) {
      for (const step of around) {
        const next = pixel + step;
        if (!meeting.has(next) || owners.has(next)) continue;
        owners.set(next, nodes.length);
        members.push(next);
      }
    }
    nodes.push({
      x: members.reduce((sum, pixel) => sum + (pixel % width), 0) / members.length,
      y: members.reduce((sum, pixel) => sum + Math.floor(pixel / width), 0) / members.length,
      radius: Math.max(...members.map((pixel) => distances[pixel])),
    });
  }
  return nodes;
}

/** Follows a line from a pixel beside a junction, or from a free end, and removes its pixels from the skeleton. */
function follow(tracer: Tracer, start: number, from: number, before: number): void {
  const { skeleton, distances, width, around, owners, branches } = tracer;
  const branch: Branch = { points: [], radii: [], from, to: NO_NODE };
  let last = before;
  for (let pixel = start; ; ) {
    branch.points.push(pixel % width, Math.floor(pixel / width));
    branch.radii.push(distances[pixel]);
    skeleton[pixel] = 0;
    let next = -1;
    let node = NO_NODE;
    for (const step of around) {
      const neighbour = pixel + step;
      if (!skeleton[neighbour]) continue;
      const owner = owners.get(neighbour);
      if (owner === undefined) {
        if (next < 0) next = neighbour;
      } else if (neighbour !== last && !(owner === from && branch.radii.length === 1)) node = owner;
    }
    if (node !== NO_NODE || next < 0) {
      branch.to = node;
      break;
    }
    last = pixel;
    pixel = next;
  }
  branches.push(branch);
}
