import { DataTexture, LinearFilter, RGFormat } from 'three';

let blank: DataTexture | undefined;

/** One texel of blank paper for materials without a tonal art map. Shared and never disposed of. */
export function blankThresholdMap(): DataTexture {
  if (blank === undefined) {
    blank = new DataTexture(new Uint8Array([255, 255]), 1, 1, RGFormat);
    blank.unpackAlignment = 2;
    // The filters of real maps: WebGPURenderer keeps the filter of the first texture that it binds.
    blank.magFilter = blank.minFilter = LinearFilter;
    blank.needsUpdate = true;
  }
  return blank;
}
