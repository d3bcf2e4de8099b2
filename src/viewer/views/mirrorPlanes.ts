/** Grid cells along the radius, in which a point and its mirror image are compared. */
const CELLS = 16;
/** How many planes are tried. */
const PLANES = 36;
/** The least share of a surface that is no mirror image by chance. */
const LEAST_REST = 0.05;

/** How much better upright planes through the middle of a surface mirror it than most do, from 0 to 1. */
export interface MirrorPlanes {
  /** The azimuth of a horizontal direction in the best plane, in degrees, from 0 to 180. */
  best: number;
  /** How clearly the plane that contains a direction mirrors the surface. @param azimuth of the direction, in degrees */
  clarityAt(azimuth: number): number;
}

/**
 * Finds the upright planes in which a surface is nearly its own mirror image.
 *
 * @param spread points spread evenly over the surface, as xyz
 */
export function mirrorPlanes(spread: Float32Array): MirrorPlanes {
  const centre = [0, 0, 0];
  for (let i = 0; i < spread.length; i++) centre[i % 3] += (3 * spread[i]) / spread.length;
  const points = spread.map((value, i) => value - centre[i % 3]);
  const grid = occupied(points);
  const shares = Array.from({ length: PLANES }, (_, i) => mirroredShare(points, grid, (180 * i) / PLANES));
  const usual = shares.toSorted((a, b) => a - b)[PLANES / 2];
  const clarities = shares.map((share) => Math.max(0, share - usual) / Math.max(1 - usual, LEAST_REST));
  return {
    best: (180 * shares.indexOf(Math.max(...shares))) / PLANES,
    clarityAt: (azimuth) => clarities[Math.round((azimuth / 180) * PLANES) % PLANES],
  };
}

const SIDE = 4 * CELLS + 4;

const cellOf = (x: number, y: number, z: number): number =>
  (Math.floor((x + 2) * CELLS + 1) * SIDE + Math.floor((y + 2) * CELLS + 1)) * SIDE + Math.floor((z + 2) * CELLS + 1);

/** The distances in the grid from a cell to itself and its neighbours. */
const AROUND = [-1, 0, 1].flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => (x * SIDE + y) * SIDE + z)));

/** The cells that hold a point, and their neighbours. */
function occupied(points: Float32Array): Uint8Array {
  const grid = new Uint8Array(SIDE ** 3);
  for (let i = 0; i < points.length; i += 3) {
    const cell = cellOf(points[i], points[i + 1], points[i + 2]);
    if (grid[cell] & 2) continue;
    grid[cell] |= 2;
    for (let k = 0; k < AROUND.length; k++) grid[cell + AROUND[k]] |= 1;
  }
  return grid;
}

function mirroredShare(points: Float32Array, grid: Uint8Array, azimuth: number): number {
  const nx = Math.cos((azimuth * Math.PI) / 180);
  const nz = -Math.sin((azimuth * Math.PI) / 180);
  let found = 0;
  for (let i = 0; i < points.length; i += 3) {
    const twice = 2 * (points[i] * nx + points[i + 2] * nz);
    const there = grid[cellOf(points[i] - twice * nx, points[i + 1], points[i + 2] - twice * nz)];
    found += there & 2 ? 1 : there & 1 ? 0.5 : 0;
  }
  return (3 * found) / points.length;
}
