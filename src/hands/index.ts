/**
 * Hands for hatching: six to begin with, and strokes from a picture of one's own.
 *
 * @module three-hatching/hands
 */

export type { Hand, HandNumbers, HandStroke, SwatchTone } from '../hand/Hand.js';
export type { ScannedImage } from '../scan/ScannedImage.js';
export type { TraceOptions } from '../scan/traceStrokesSteps.js';
export type { TaskOptions } from '../worker/TaskOptions.js';
export { type ExampleHandName, type ExampleHandOptions, exampleHand, exampleHandNames } from './exampleHand.js';
export { type TraceStrokesOptions, traceStrokes } from './traceStrokes.js';
