import type { TonalArtMap } from 'three-hatching';
import { ModelError } from '../../viewer/files/common/ModelError.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { readLinkedHand } from '../maps/linkedHand.js';
import type { OwnHand } from '../maps/OwnHand.js';
import type { MapOptions, MapSettings, TonalArtMapCache } from '../maps/TonalArtMapCache.js';

/** Where the last map by a hand took longer than this, in milliseconds, a small one is drawn first. */
const SOON = 500;
/** The size of a map that is there soon, and the number of its tones. */
const QUICK = { mapSize: '128', mapTones: 4 } as const;

/** What draws with the maps. */
export interface MapUser {
  readonly settings: Settings;
  hand: OwnHand | undefined;
  readonly map: TonalArtMap | undefined;
  /**
   * @param settings that say which map it is
   * @param tileScale how many of its tiles stand for one
   */
  use(map: TonalArtMap, settings: MapSettings, tileScale?: number): void;
}

/**
 * Draws with the user's own hand: with a small map first, if the last one took long. A hand that came with a link is read now.
 *
 * @throws ModelError with a sentence for the user, if that is damaged
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
    // There is a drawing all the same.
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
