/**
 * Twelve example hands, generated from parameters.
 *
 * @module three-hatching/hands
 */

export { type ExampleHandName, type ExampleHandOptions, exampleHand, exampleHandNames } from './exampleHand.js';
