import { loadMesh } from '../bake/loadMesh.js';
import {
  buildTriangleAdjacency,
  combedField,
  consistentTwins,
  cutForm,
  directionField,
  FORM_DEFAULTS,
  faceDirections,
  formSurface,
  measureBounds,
  nearnessOf,
} from '../internals.js';
import { PhaseClock } from '../PhaseClock.js';

/**
 * Bakes the form field of a model as often as `repeats` says, by phase, on the page's main thread. The adjacency, which every bake
 * finds, is not counted.
 */
export async function measureForm(model: string, repeats: number) {
  const mesh = await loadMesh(model);
  const { run: before } = new PhaseClock();
  const bounds = before('', measureBounds(mesh));
  const adjacency = before('', buildTriangleAdjacency(mesh, nearnessOf(bounds)));
  const twins = before('', consistentTwins(adjacency));
  const runs = Array.from({ length: repeats }, () => {
    const clock = new PhaseClock();
    const surface = clock.run('surface', formSurface(mesh, adjacency, twins, bounds.radius, FORM_DEFAULTS));
    const field = clock.run('directions', directionField(surface, FORM_DEFAULTS));
    const directions = clock.run('cut', faceDirections(surface, field));
    const seam = clock.run('cut', cutForm(surface, directions));
    const { statistics } = clock.run('lines', combedField(surface, directions, seam, FORM_DEFAULTS.crossAngle));
    return { clock, vertices: surface.fans.count, statistics };
  });
  return {
    triangles: mesh.indices.length / 3,
    times: runs.map(({ clock }) => clock.times),
    longestSteps: runs.map(({ clock }) => clock.longestStep),
    vertices: runs[0].vertices,
    ...runs[0].statistics,
  };
}
