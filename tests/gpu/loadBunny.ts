import { createRequire } from 'node:module';
import type { PlainMesh } from '../reference/meshes.js';

const { positions, cells } = createRequire(import.meta.url)('bunny') as { positions: number[][]; cells: number[][] };

/** The Stanford bunny of 3,674 triangles, centred and scaled to a radius of about 1. */
export function loadBunny(): PlainMesh {
  const axis = (i: number) => positions.map((p) => p[i]);
  const centre = [0, 1, 2].map((i) => (Math.min(...axis(i)) + Math.max(...axis(i))) / 2);
  return {
    positions: positions.flatMap((p) => p.map((x, i) => (x - centre[i]) / 6)),
    indices: cells.flat(),
  };
}
