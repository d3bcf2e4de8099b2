import { TonalArtMap } from 'three-hatching';
import { shownName } from '../../viewer/files/common/shownText.js';
import type { ModelFile } from '../../viewer/files/readModel.js';
import { handLook } from '../../viewer/settings/handLook.js';
import { readHandFile } from '../maps/readOwnHand.js';
import type { MapOptions, TonalArtMapCache } from '../maps/TonalArtMapCache.js';
import { type MapUser, showHandMap } from './showHandMap.js';

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
  const { ZipWriter } = await import('../print/BlobWriter.js');
  const zip = new ZipWriter();
  for (const file of await map.save()) await zip.add(file.name, file);
  return zip.end();
}
