import { DataArrayTexture } from 'three';

let blank: DataArrayTexture | undefined;

/** One texel for materials without a tonal art map, which print nothing of it. Shared and never disposed of. */
export function blankTonalArtMap(): DataArrayTexture {
  if (blank === undefined) {
    blank = new DataArrayTexture(new Uint8Array([255, 255, 255, 255]), 1, 1, 1);
    blank.needsUpdate = true;
  }
  return blank;
}
