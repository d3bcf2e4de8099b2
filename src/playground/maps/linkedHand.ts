import type { Hand, HandNumbers, HandStroke } from 'three-hatching';
import { readHand, writeHand } from '../../viewer/settings/handLink.js';
import { HAND_FILE, type OwnHand } from './OwnHand.js';

/** Creates the user's own hand, with its text for links and its file. */
export const ownHandOf = (
  hand: Hand,
  strokes: readonly HandStroke[] = hand.strokes,
  changed?: Partial<HandNumbers>,
  link = writeHand(hand),
): OwnHand => ({
  ...{ hand, strokes, changed, link },
  files: [{ name: HAND_FILE, content: new Blob([JSON.stringify(hand)], { type: 'application/json' }) }],
});

/** Reads a hand from a link. Undefined if it is damaged. */
export function readLinkedHand(own: OwnHand): OwnHand | undefined {
  if (own.hand || own.link === undefined) return own;
  const hand = readHand(own.link);
  return hand && ownHandOf(hand, hand.strokes, undefined, own.link);
}
