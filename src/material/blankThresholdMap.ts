import { DataTexture, LinearFilter, RGFormat } from 'three';

let blank: DataTexture | undefined;

/** One texel for materials without a tonal art map, which print nothing of it. Shared and never disposed of. */
export function blankThresholdMap(): DataTexture {
  if (blank === undefined) {
    blank = new DataTexture(new Uint8Array([255, 255]), 1, 1, RGFormat);
    blank.unpackAlignment = 2;
    // As those of maps: WebGPURenderer keeps the filter of the texture that it has met first.
    blank.magFilter = blank.minFilter = LinearFilter;
    blank.needsUpdate = true;
  }
  return blank;
}
