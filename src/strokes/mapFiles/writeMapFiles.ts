import type { HatchImages } from '../tamImages/HatchImages.js';
import { encodePng } from './encodePng.js';
import { MAP_FILE, MAP_FORMAT, MAP_VERSION, type MapDescription, type MapFile, THRESHOLD_STEP } from './mapFiles.js';

/**
 * Writes the files of a map: a JSON file that names the others, a grey PNG image for each tone and level and, with thresholds, an
 * RGB image for each level. `readMap` reads back exactly the same map.
 *
 * @param thresholds the thresholds of every level, if they were drawn and not derived from the images
 */
export async function writeMapFiles(
  { size, images, strokeTexels }: HatchImages,
  thresholds?: readonly Float32Array[],
): Promise<MapFile[]> {
  const files: Promise<MapFile>[] = [];
  const write = (name: string, level: number, channels: 1 | 3, data: Uint8Array): string => {
    const side = size >> level;
    files.push(encodePng({ width: side, height: side, channels, data }).then((bytes) => ({ name, bytes })));
    return name;
  };
  const description: MapDescription = {
    format: MAP_FORMAT,
    version: MAP_VERSION,
    size,
    ...(strokeTexels !== undefined && { strokeTexels }),
    images: images.map((row, tone) =>
      row.map((image, level) => write(`tone-${tone}-level-${level}.png`, level, 1, image)),
    ),
    ...(thresholds && {
      thresholds: thresholds.map((field, level) =>
        write(`thresholds-level-${level}.png`, level, 3, rgbFromThresholds(field)),
      ),
    }),
  };
  const json = new TextEncoder().encode(`${JSON.stringify(description, undefined, 2)}\n`);
  return [{ name: MAP_FILE, bytes: json }, ...(await Promise.all(files))];
}

/** Writes each threshold as three bytes, the most significant first. */
function rgbFromThresholds(thresholds: Float32Array): Uint8Array {
  const bytes = new Uint8Array(3 * thresholds.length);
  for (let i = 0; i < thresholds.length; i++) {
    const steps = thresholds[i] / THRESHOLD_STEP;
    bytes[3 * i] = steps >> 16;
    bytes[3 * i + 1] = steps >> 8;
    bytes[3 * i + 2] = steps;
  }
  return bytes;
}
