import { ModelError } from '../common/ModelError.js';

/** The memory of a mesh while it is read: its vertices and corners, and the room in which their lists grow. */
const BYTES_PER_READ_TRIANGLE = 50;
/** The memory that a page can get for one model, beside the copies that are held while it is read and baked. */
const MAX_BYTES = 2 ** 30;
/**
 * The memory of a large mesh once it is baked: layout `pull`, with normals, colours and the data of lines. It was measured on a million
 * triangles.
 */
const BYTES_PER_TRIANGLE = 205;
/** A round number, since a message gives it. */
const MAX_TRIANGLES = Math.floor(MAX_BYTES / BYTES_PER_TRIANGLE / 1e5) * 1e5;

/** Whether memory allows to draw so many triangles. */
export const canDraw = (triangles: number): boolean => triangles <= MAX_TRIANGLES;

const MAX_READ_TRIANGLES = Math.floor(MAX_BYTES / BYTES_PER_READ_TRIANGLE / 1e6) * 1e6;

/** @throws ModelError if there are no triangles to read, or more than memory allows before they are simplified */
export const checkReadTriangles = (triangles: number): void => checkCount(triangles, MAX_READ_TRIANGLES);

/** @throws ModelError if there are no triangles to draw, or more than memory allows */
export const checkTriangleCount = (triangles: number): void => checkCount(triangles, MAX_TRIANGLES);

function checkCount(triangles: number, most: number): void {
  if (!(triangles > 0)) {
    throw new ModelError('The file holds no triangles; only surfaces can be hatched, not points or lines.');
  }
  if (triangles > most) {
    throw new ModelError(
      `The model has more than ${most.toLocaleString('en')} triangles, for which a page has no memory.`,
    );
  }
}
