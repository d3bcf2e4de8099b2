import { asPhase } from '../phases.js';
import { type HatchedVertices, hatchedMesh } from './hatchedMesh.js';
import { simplifierOf } from './loadSimplifier.js';
import { type DetailLevels, makeLevels } from './makeLevels.js';

/** A baked mesh to simplify. */
export interface DetailRequest extends HatchedVertices {
  indices: Uint32Array<ArrayBuffer>;
  /** Radius of the bounding sphere, in object units. */
  radius: number;
  /** The URL of meshoptimizer's simplifier. */
  simplifier: string;
}

/** Makes the levels of a baked mesh. The simplifier must be loaded. */
export function* simplifyHatched(request: DetailRequest): Generator<number, DetailLevels, void> {
  const { radius, indices } = request;
  const mesh = yield* asPhase(hatchedMesh(request, radius), 0, 0.05);
  return yield* asPhase(makeLevels(mesh, indices, radius, simplifierOf(request.simplifier)), 0.05, 1);
}
