import { runToEnd } from '../../mesh/phases.js';
import type { UpAxis } from '../files/mesh/findUpAxis.js';
import { oneSided } from '../files/mesh/PlainMesh.js';
import type { ReadModel } from '../files/readModel.js';
import { chooseViews } from './chooseViews.js';

/** Adds the views that show a mesh best. A model in parts gets them when its parts are put together. @param up the axis that points up */
export function withViews(read: ReadModel, up: UpAxis): ReadModel {
  if (read.kind !== 'mesh') return read;
  const { positions, indices } = read.mesh;
  return { ...read, views: runToEnd(chooseViews({ positions, indices, isSingleSided: oneSided(read.mesh) }, up)) };
}
