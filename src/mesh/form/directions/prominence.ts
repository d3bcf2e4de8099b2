import { forEachChunk } from '../../phases.js';
import type { FormOptions } from '../FormField.js';
import type { FormSurface } from '../FormSurface.js';
import { normalized, type Vector, viewedFrom } from './axes.js';

/** Natural logarithm of the ratio between the prominence of the front and that of the sides. */
const FRONT_EXPONENT = 1;

/** The same for surfaces that face up: objects are seen from above rather than below, where their shadows lie. */
const UP_EXPONENT = 1.2;

/**
 * The visual weight of each fan: the front weighs seven times as much as the back, and what faces up eleven times as much as what faces
 * down. Turns of the field cost as much as they are visible, so singular points, around which it turns most, move to the sides, the back
 * and below.
 *
 * @param signs see `bendSigns`
 */
export function* prominence(
  { fans, normals }: Pick<FormSurface, 'fans' | 'normals'>,
  signs: Int8Array,
  { up, front }: Pick<FormOptions, 'up' | 'front'>,
): Generator<number, Float32Array, void> {
  const axis = normalized(up);
  const facing = normalized(viewedFrom(axis, front));
  const most = axis.map((value, i) => UP_EXPONENT * value + FRONT_EXPONENT * facing[i]) as unknown as Vector;
  const prominences = new Float32Array(fans.count);
  yield* forEachChunk(fans.count, (start, end) => showRange(normals, signs, most, prominences, start, end));
  return prominences;
}

function showRange(
  normals: Float32Array,
  signs: Int8Array,
  [x, y, z]: Vector,
  prominences: Float32Array,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const height = normals[3 * fan] * x + normals[3 * fan + 1] * y + normals[3 * fan + 2] * z;
    prominences[fan] = Math.exp(signs[fan] * height);
  }
}
