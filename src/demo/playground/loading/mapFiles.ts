import { TonalArtMap } from 'three-hatching';
import { shownName } from '../../../files/common/shownText.js';
import type { ModelFile } from '../../../files/readModel.js';

/** Reads dropped files as a map. @throws Error with a message for the user */
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

/** Packs all files of a map into one archive. PNG images are compressed already, so they are stored as they are. */
export async function zipMap(map: TonalArtMap): Promise<Blob> {
  const { ZipWriter } = await import('../../print/ZipWriter.js');
  const zip = new ZipWriter();
  for (const file of await map.save()) await zip.add(file.name, file);
  return zip.end();
}
