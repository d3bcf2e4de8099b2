import type { Hand, HandNumbers, HandStroke } from 'three-hatching';
import type { ModelFile } from '../../viewer/files/common/ModelFile.js';

/** The user's own hand so far. Immutable, because Undo returns to earlier ones. */
export interface OwnHand {
  /** The strokes on the sheet, as drawn. */
  readonly strokes: readonly HandStroke[];
  /** The hand learnt from them, with the user's changes; undefined while there are too few strokes. */
  readonly hand: Hand | undefined;
  /**
   * The numbers changed by the user, which stay when more strokes are drawn; undefined for a hand that was read, where they are unknown.
   */
  readonly changed: Partial<HandNumbers> | undefined;
  /** The hand as text for a link; undefined if too long. For a hand from a link, the only known field until it is read. */
  readonly link: string | undefined;
  /** The hand as a file, stored with the drawing. */
  readonly files: readonly ModelFile[] | undefined;
}

/** A hand from a link that has not been read yet. */
export const linkedHand = (link: string | undefined): OwnHand | undefined =>
  link === undefined ? undefined : { strokes: [], hand: undefined, changed: undefined, link, files: undefined };

/** The file name of a hand. */
export const HAND_FILE = 'hand.json';
