import type { Hand, HandNumbers, HandStroke } from 'three-hatching';
import type { ModelFile } from '../../viewer/files/common/ModelFile.js';

/** The user's own hand, as far as it is drawn. It is never changed in place, because Undo goes back to earlier ones. */
export interface OwnHand {
  /** The strokes on the sheet, as they were drawn. */
  readonly strokes: readonly HandStroke[];
  /** What was learnt from them, with the numbers that the user has changed; undefined while there are too few. */
  readonly hand: Hand | undefined;
  /** The numbers that the user has changed, which stay when more strokes are drawn; undefined if they are not known: the hand was read. */
  readonly changed: Partial<HandNumbers> | undefined;
  /** The hand as a text for links; undefined if it is too long for one. Of a hand from a link, nothing else is known until it is read. */
  readonly link: string | undefined;
  /** The hand as a file, to be kept with the drawing. */
  readonly files: readonly ModelFile[] | undefined;
}

/** A hand that came with a link, as long as it is not read. */
export const linkedHand = (link: string | undefined): OwnHand | undefined =>
  link === undefined ? undefined : { strokes: [], hand: undefined, changed: undefined, link, files: undefined };

/** The name of the file of a hand. */
export const HAND_FILE = 'hand.json';
