import type { PackedOutlines } from '../../mesh/bake/packOutlines.js';
import { runTask } from '../../worker/runTask.js';
import type { TaskOptions } from '../../worker/TaskOptions.js';

/** Measures in the worker how far apart the outlines of a surface of many parts lie. Changes the outlines. */
export async function spaceOutlines(outlines: PackedOutlines, { signal, createWorker }: TaskOptions): Promise<void> {
  const copies = () => {
    const { positions, normals, primitives, triangleCount, edgeCount, radius } = outlines;
    return {
      ...{ positions: positions.slice(), normals: normals.slice(), primitives: primitives.slice() },
      ...{ triangleCount, edgeCount, radius },
    };
  };
  outlines.primitives = await runTask('lineSpacings', copies(), { signal, createWorker }, copies);
  if (outlines.searched) outlines.searched = outlines.primitives.slice();
}
