import { forEachChunk } from '../../phases.js';
import type { FormOptions } from '../FormField.js';
import type { FormSurface } from '../FormSurface.js';
import { normalized, type Vector, viewedFrom } from './axes.js';

/** The natural logarithm of how much more counts what faces the front than what faces the sides. */
const FRONT_EXPONENT = 1;

/** The same for what faces up: objects are seen from above rather than from below, and their shadows lie there. */
const UP_EXPONENT = 1.2;

/**
 * How much each fan shows: what faces the front counts seven times as much as the back, and what faces up eleven times as much as what
 * faces down. Where a field of lines turns costs as much as it shows. Singular points, around which it turns most, so leave the front
 * for the sides, the back and below.
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
