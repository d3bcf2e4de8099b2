import type { FirstDraw } from './FirstDraw.js';
import type { Mistake } from './sentences.js';

/**
 * Registers a mistake.
 *
 * @param culprit the object to change; a mistake is reported once per culprit
 * @param details the further arguments of the message, after the name of the mesh
 */
export type NoteMistake = (mistake: Mistake, draw: FirstDraw, culprit: object, ...details: string[]) => void;
