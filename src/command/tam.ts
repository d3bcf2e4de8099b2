import process from 'node:process';
import { version } from '../../package.json';
import { runSliced } from '../mesh/runSliced.js';
import { requestOfHand } from '../strokes/handStyle.js';
import type { MapFile } from '../strokes/mapFiles/mapFiles.js';
import { writeMapFiles } from '../strokes/mapFiles/writeMapFiles.js';
import { generateHatchImages } from '../strokes/tamImages/generateHatchImages.js';
import { generateThresholds } from '../strokes/tamImages/generateThresholds.js';
import { type MapDrawing, resolveMapDrawing } from '../strokes/tamImages/hatchImageOptions.js';
import { OutputFolder } from './OutputFolder.js';
import { HELP, parseArguments, styleList } from './parseArguments.js';
import type { ProgressBar } from './standardStreams.js';

/**
 * Runs the command `tam`.
 *
 * @param args the arguments, without node and the script
 * @throws UsageError if they are not valid, or Error whose message is a sentence, or the reason of the signal
 */
export async function tam(args: readonly string[], signal: AbortSignal, bar: ProgressBar): Promise<void> {
  const request = parseArguments(args);
  if (request.action === 'help') process.stdout.write(HELP);
  else if (request.action === 'version') process.stdout.write(`${version}\n`);
  else if (request.action === 'list') process.stdout.write(styleList());
  else {
    const { map, out, force } = request;
    const folder = new OutputFolder(out, force);
    try {
      await folder.open(maxBytes(map));
      const files = await draw(map, signal, bar);
      await folder.write(files, signal);
      bar.clear();
      process.stdout.write(`${out}: ${files.length} files. Load it with TonalArtMap.load('${out}/map.json').\n`);
    } finally {
      await folder.close();
    }
  }
}

async function draw(map: MapDrawing, signal: AbortSignal, bar: ProgressBar): Promise<MapFile[]> {
  const request = await runSliced(requestOfHand(map), { signal });
  const images = await runSliced(generateHatchImages(request), {
    signal,
    onProgress: (progress) => bar.show('drawing tones', 0.7 * progress),
  });
  const levels = await runSliced(generateThresholds(request), {
    signal,
    onProgress: (progress) => bar.show('drawing thresholds', 0.7 + 0.25 * progress),
  });
  bar.show('writing', 0.95);
  return writeMapFiles(
    images,
    levels.map(({ thresholds }) => thresholds),
  );
}

/** An upper bound for the size of a map's files, in bytes: its images and thresholds without compression. */
function maxBytes(map: MapDrawing): number {
  const { size, tones } = resolveMapDrawing(map);
  return Math.ceil((4 / 3) * size ** 2 * (tones + 3));
}
