/**
 * Six hands to begin with, drawn by numbers.
 *
 * @module three-hatching/hands
 */

export { type ExampleHandName, type ExampleHandOptions, exampleHand, exampleHandNames } from './exampleHand.js';
