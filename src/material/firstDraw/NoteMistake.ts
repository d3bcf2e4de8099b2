import type { FirstDraw } from './FirstDraw.js';
import type { Mistake } from './sentences.js';

/**
 * Takes notice of a mistake.
 *
 * @param culprit what would have to be changed; nobody is told twice of the same
 * @param details what the sentence says beside the name of the mesh
 */
export type NoteMistake = (mistake: Mistake, draw: FirstDraw, culprit: object, ...details: string[]) => void;
