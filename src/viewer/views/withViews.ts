import { type OnStage, runStage } from '../files/common/stages.js';
import { oneSided } from '../files/mesh/PlainMesh.js';
import type { UpAxis } from '../files/mesh/UpAxis.js';
import type { ReadModel } from '../files/readModel.js';
import { cameraSights, sightedCameras } from './cameraSights.js';
import { chooseViews } from './chooseViews.js';

/**
 * Adds the views that show a mesh best, and leaves out cameras that do not see it. A model in parts gets them when its parts are put
 * together.
 *
 * @param up the axis that points up
 */
export function withViews(read: ReadModel, up: UpAxis, onStage: OnStage): ReadModel {
  if (read.kind !== 'mesh') return read;
  const { positions, indices, parts } = read.mesh;
  const triangles = { positions, indices, isSingleSided: oneSided(read.mesh), parts };
  const views = runStage('looking for a view', onStage, chooseViews(triangles, up));
  if (!read.extras) return { ...read, views };
  const { extras } = read;
  const { cameras, details } = sightedCameras(extras.cameras, cameraSights(triangles, extras.cameras));
  return { ...read, views, extras: { ...extras, cameras }, details: [...read.details, ...details] };
}
