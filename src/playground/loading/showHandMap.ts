import type { TonalArtMap } from 'three-hatching';
import { ModelError } from '../../viewer/files/common/ModelError.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import type { OwnHand } from '../maps/OwnHand.js';
import { readLinkedHand } from '../maps/readOwnHand.js';
import type { MapOptions, MapSettings, TonalArtMapCache } from '../maps/TonalArtMapCache.js';

/** If the previous map of a hand took longer than this, in milliseconds, a preview is drawn first. */
const SOON = 500;
/** Size and tones of the preview. */
const QUICK = { mapSize: '128', mapTones: 4 } as const;

/** Receives the maps. */
export interface MapUser {
  readonly settings: Settings;
  hand: OwnHand | undefined;
  readonly map: TonalArtMap | undefined;
  /**
   * @param settings of the map
   * @param tileScale factor on its tiles, above 1 for a preview
   */
  use(map: TonalArtMap, settings: MapSettings, tileScale?: number): void;
}

/**
 * Draws with the user's own hand, with a small preview first if the previous map took long. A hand from a link is read here.
 *
 * @throws ModelError with a sentence for the user, if it is damaged
 */
export async function showHandMap(
  cache: TonalArtMapCache,
  chosen: MapSettings,
  options: MapOptions,
  user: MapUser,
): Promise<void> {
  const { signal } = options;
  const before = user.hand;
  const own = before && readLinkedHand(before);
  const hand = own?.hand;
  if (!hand) {
    // Draws in the default style, so that there is a drawing at all.
    const plain = { ...chosen, mapStyle: SETTINGS.mapStyle.default };
    if (!user.map) user.use(await cache.get(plain, options, undefined), plain);
    throw new ModelError('The hand in this link is damaged: ask for the link again, or for the hand as a file.');
  }
  user.hand = own;
  const tileScale = Number(chosen.mapSize) / Number(QUICK.mapSize);
  if (tileScale > 1 && cache.handTime > SOON && !cache.has(chosen, hand)) {
    const quick = await cache.get({ ...chosen, ...QUICK }, options, user.map, hand);
    signal.throwIfAborted();
    user.use(quick, chosen, tileScale);
  }
  const map = await cache.get(chosen, options, user.map, hand);
  if (!signal.aborted) user.use(map, chosen);
}
