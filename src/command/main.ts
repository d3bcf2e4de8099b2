#!/usr/bin/env node
import process from 'node:process';
import { generateHatchImages } from '../hatchImages/generateHatchImages.js';
import { generateThresholds } from '../hatchImages/generateThresholds.js';
import { type MapDrawing, resolveMapDrawing } from '../hatchImages/hatchImageOptions.js';
import type { MapFile } from '../mapFiles/mapFiles.js';
import { writeMapFiles } from '../mapFiles/writeMapFiles.js';
import { runSliced } from '../slices/runSliced.js';
import { OutputFolder } from './OutputFolder.js';
import { ProgressBar } from './ProgressBar.js';
import { HELP, parseArguments, styleList, UsageError } from './parseArguments.js';

/** Exit codes: 0 done, 1 failed, 2 called wrongly, 130 interrupted. */
const FAILED = 1;
const MISUSED = 2;
const INTERRUPTED = 130;

const abort = new AbortController();
process.on('SIGINT', () => abort.abort());
process.on('SIGTERM', () => abort.abort());
const bar = new ProgressBar(process.stderr);

try {
  const request = parseArguments(process.argv.slice(2));
  if (request.action === 'help') process.stdout.write(HELP);
  else if (request.action === 'list') process.stdout.write(styleList());
  else {
    const { map, out, force } = request;
    const folder = new OutputFolder(out, force);
    try {
      await folder.open(maxBytes(map));
      const files = await draw(map);
      await folder.write(files, abort.signal);
      bar.clear();
      process.stdout.write(`${out}: ${files.length} files. Load it with TonalArtMap.load('${out}/map.json').\n`);
    } finally {
      await folder.close();
    }
  }
} catch (error) {
  bar.clear();
  process.exitCode = reportError(error);
}

async function draw(map: MapDrawing): Promise<MapFile[]> {
  const { signal } = abort;
  const images = await runSliced(generateHatchImages(map), {
    signal,
    onProgress: (progress) => bar.show('drawing tones', 0.7 * progress),
  });
  const levels = await runSliced(generateThresholds(map), {
    signal,
    onProgress: (progress) => bar.show('drawing thresholds', 0.7 + 0.25 * progress),
  });
  bar.show('writing', 0.95);
  return writeMapFiles(
    images,
    levels.map(({ thresholds }) => thresholds),
  );
}

/** The largest possible size of the files of a map, in bytes: that of its images and thresholds without compression. */
function maxBytes(map: MapDrawing): number {
  const { size, tones } = resolveMapDrawing(map);
  return Math.ceil((4 / 3) * size ** 2 * (tones + 3));
}

/** Prints the message of an error and returns the exit code. */
function reportError(error: unknown): number {
  if (abort.signal.aborted) {
    process.stderr.write('three-hatching: interrupted; nothing was written.\n');
    return INTERRUPTED;
  }
  process.stderr.write(`three-hatching: ${error instanceof Error ? error.message : String(error)}\n`);
  return error instanceof UsageError ? MISUSED : FAILED;
}
