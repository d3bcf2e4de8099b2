import type { HatchImages } from '../tamImages/HatchImages.js';
import type { Pixels } from './decodePng.js';
import { MAP_FILE, MAP_FORMAT, MAP_VERSION, type MapDescription, type MapFile, THRESHOLD_STEP } from './mapFiles.js';
import { PNG_COLOR_TYPE, PNG_SIGNATURE, pngChunk, pngHeader } from './pngFormat.js';

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

/**
 * Encodes bytes as a PNG file with one or three channels of eight bits. No colour profile is written, so readers do not
 * convert the values.
 */
export async function encodePng({ width, height, channels, data }: Pixels): Promise<Uint8Array> {
  const stride = width * channels;
  const rows = new Uint8Array(height * (stride + 1));
  // The byte before each row is the number of its filter; 0 means none.
  for (let row = 0; row < height; row++) {
    rows.set(data.subarray(row * stride, (row + 1) * stride), row * (stride + 1) + 1);
  }
  return concatenate([
    PNG_SIGNATURE,
    pngHeader(width, height, 8, channels === 1 ? PNG_COLOR_TYPE.grey : PNG_COLOR_TYPE.rgb),
    pngChunk('IDAT', await deflate(rows)),
    pngChunk('IEND'),
  ]);
}

async function deflate(bytes: Uint8Array): Promise<Uint8Array> {
  const stream = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new CompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function concatenate(parts: readonly Uint8Array[]): Uint8Array {
  const result = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    result.set(part, at);
    at += part.length;
  }
  return result;
}
