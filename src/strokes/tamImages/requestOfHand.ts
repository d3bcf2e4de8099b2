import { handStyle } from '../handStyle.js';
import { prepareHand } from '../prepareHand.js';
import { type MapDrawing, resolveMapDrawing } from './hatchImageOptions.js';
import type { MapRequest } from './hatchImageRequest.js';

/**
 * Makes the request for a map, with the style of its hand if it has one. It takes a few milliseconds, and lies apart from what draws, so
 * that the worker, which every page loads, need not hold it.
 *
 * @throws TypeError or RangeError if the hand is none; yields progress in [0, 1]
 */
export function* requestOfHand({ hand, ...drawing }: MapDrawing): Generator<number, MapRequest, void> {
  if (!hand) return drawing;
  const { strokeTexels, size } = resolveMapDrawing(drawing);
  return { ...drawing, hand: handStyle(yield* prepareHand(hand), strokeTexels, size) };
}
