import type { BufferGeometry, Matrix4 } from 'three';
import type { JointForm } from '../../mesh/bake/bakeJointForms.js';
import { runTask } from '../../worker/runTask.js';
import { cornerRange, extractMesh } from './extractMesh.js';
import { formRequest } from './HatchingFormOptions.js';
import { DEFAULT_CREASE_ANGLE, type PrepareHatchingGeometryOptions } from './PrepareHatchingGeometryOptions.js';

/** A geometry that is part of a larger whole. */
export interface GeometryPart {
  geometry: BufferGeometry;
  /** The matrix from its object space to a space that all parts share. */
  matrix: Matrix4;
}

/**
 * Bakes the form fields of geometries whose borders meet as if they were one, in a worker, for `prepareWithForm`. It rejects as
 * `prepareHatchingGeometry` does.
 *
 * @param options `form` with axes in the space that the parts share
 */
export async function bakeJointForms(
  parts: readonly GeometryPart[],
  options: PrepareHatchingGeometryOptions,
): Promise<readonly JointForm[]> {
  const request = () => ({
    parts: parts.map(({ geometry, matrix }) => ({
      mesh: extractMesh(geometry, cornerRange(geometry, 'applyHatching')),
      matrix: matrix.toArray(),
    })),
    creaseAngle: options.creaseAngle ?? DEFAULT_CREASE_ANGLE,
    weldTolerance: options.weldTolerance,
    form: formRequest('applyHatching', options.form)!,
  });
  return runTask('bakeJointForms', request(), options, request);
}
