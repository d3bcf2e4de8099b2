import { DataTexture, RGFormat } from 'three';

let blank: DataTexture | undefined;

/** One texel for materials without a tonal art map, which print nothing of it. Shared and never disposed of. */
export function blankThresholdMap(): DataTexture {
  if (blank === undefined) {
    blank = new DataTexture(new Uint8Array([255, 255]), 1, 1, RGFormat);
    blank.unpackAlignment = 2;
    blank.needsUpdate = true;
  }
  return blank;
}
