import { bakeIndexed, type TriangleMesh } from '../internals.js';
import { torusMesh } from '../torusMesh.js';
import { loadMesh } from './loadMesh.js';

/** The mesh to bake: a model of `loadMesh`, or a torus with the given number of triangles. */
type Source = string | number;

/**
 * Bakes each mesh to the `indexed` layout, without and with outlines, on the page's main thread. They take turns, so that what slows the
 * machine down slows all of them down. A first turn, in which code is compiled, does not count.
 *
 * @returns for each mesh its number of triangles, and the milliseconds of each bake
 */
export async function measureWholeBake(sources: readonly Source[], turns: number) {
  const meshes = await Promise.all(
    sources.map(async (source) => (typeof source === 'number' ? torusMesh(source) : await loadMesh(source))),
  );
  const results = meshes.map(({ indices }) => ({
    triangles: indices.length / 3,
    plain: [] as number[],
    outlined: [] as number[],
  }));
  for (let turn = 0; turn <= turns; turn++) {
    for (const [i, mesh] of meshes.entries()) {
      const plain = timeBake(mesh, false);
      const outlined = timeBake(mesh, true);
      if (turn === 0) continue;
      results[i]!.plain.push(plain);
      results[i]!.outlined.push(outlined);
      // Garbage of earlier bakes must not be collected during the next one alone.
      await new Promise((resolve) => setTimeout(resolve));
    }
  }
  return results;
}

function timeBake(mesh: TriangleMesh, hasOutlines: boolean): number {
  const task = bakeIndexed({
    label: 'benchmark',
    mesh,
    creaseAngle: Math.PI / 2,
    wantsNormals: false,
    outlines: hasOutlines ? { triangleGroups: null } : null,
  });
  const start = performance.now();
  while (!task.next().done);
  return performance.now() - start;
}
