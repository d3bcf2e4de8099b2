import type { Mesh } from 'three';
import { describeObject } from '../material/diagnostics/describeObject.js';
import type { SkippedMesh } from './HatchedScene.js';

/** The function name at the beginning of an error message. */
const CALLER = /^\w+: /;

/** A mesh that could not be read or prepared, with a sentence that names it. */
export function failure(mesh: Mesh, error: Error): SkippedMesh {
  return { mesh, reason: `The ${describeObject(mesh)} is left as it is: ${error.message.replace(CALLER, '')}`, error };
}
