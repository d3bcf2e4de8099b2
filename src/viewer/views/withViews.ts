import { runToEnd } from '../../mesh/phases.js';
import type { UpAxis } from '../files/mesh/findUpAxis.js';
import { type PlainMesh, triangleCount } from '../files/mesh/PlainMesh.js';
import type { ReadModel } from '../files/readModel.js';
import { chooseViews } from './chooseViews.js';

/** Adds the views that show a mesh best. A model in parts gets them when its parts are put together. @param up the axis that points up */
export function withViews(read: ReadModel, up: UpAxis): ReadModel {
  if (read.kind !== 'mesh') return read;
  const { positions, indices } = read.mesh;
  return { ...read, views: runToEnd(chooseViews({ positions, indices, isSingleSided: oneSided(read.mesh) }, up)) };
}

/** Whether the back of each triangle is hidden, as far as the file says so; null if it is of none. */
function oneSided(mesh: PlainMesh): Uint8Array | null {
  const { isOneSided, ranges = [{ start: 0, count: 3 * triangleCount(mesh), isOneSided }] } = mesh;
  const hidden = ranges.filter((range) => range.isOneSided);
  if (hidden.length === 0) return null;
  const sides = new Uint8Array(triangleCount(mesh));
  for (const { start, count } of hidden) sides.fill(1, start / 3, (start + count) / 3);
  return sides;
}
