import { TonalArtMap } from 'three-hatching';
import { ModelError, shownName } from '../../viewer/files/common/ModelError.js';
import type { ModelFile } from '../../viewer/files/readModel.js';
import { handLook } from '../../viewer/settings/handLook.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { readHandFile, readLinkedHand } from '../hand/ownHand.js';
import type { OwnHand } from '../session/DrawingState.js';
import type { MapOptions, MapSettings, TonalArtMapCache } from './TonalArtMapCache.js';

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

/** Reads dropped files as a tonal art map. @throws Error with a message for the user */
export async function loadMapFiles(
  files: readonly ModelFile[],
  options: { signal: AbortSignal; onProgress: (progress: number) => void },
): Promise<TonalArtMap> {
  try {
    return await TonalArtMap.load(
      files.map(({ name, content }) => new File([content], name)),
      options,
    );
  } catch (error) {
    if (options.signal.aborted) throw error;
    const sentence = (error as Error).message.replace(/^TonalArtMap\.\w+: /, '');
    throw new Error(files.reduce((text, { name }) => text.replaceAll(name, shownName(name)), sentence));
  }
}

/**
 * Draws with a hand, if the files contain one.
 *
 * @returns whether they do
 * @throws ModelError with a sentence for the user, if it is damaged
 */
export async function showHandFile(
  files: readonly ModelFile[],
  cache: TonalArtMapCache,
  options: MapOptions,
  user: MapUser,
): Promise<boolean> {
  const [file] = files;
  const hand = files.length === 1 && /\.json$/i.test(file.name) ? await readHandFile(file) : undefined;
  options.signal.throwIfAborted();
  if (!hand?.hand) return false;
  const look = handLook(user.settings, hand.hand);
  user.hand = hand;
  await showHandMap(cache, { ...user.settings, ...look }, options, user);
  options.signal.throwIfAborted();
  Object.assign(user.settings, look);
  return true;
}

/** Packs the files of a map into one archive. PNG images are compressed already, so they are stored. */
export async function zipMap(map: TonalArtMap): Promise<Blob> {
  const { ZipWriter } = await import('../export/zip.js');
  const zip = new ZipWriter();
  for (const file of await map.save()) await zip.add(file.name, file);
  return zip.end();
}
