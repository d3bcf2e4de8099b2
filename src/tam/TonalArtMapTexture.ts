import {
  CompressedArrayTexture,
  type CompressedPixelFormat,
  LinearFilter,
  LinearMipmapLinearFilter,
  NoColorSpace,
  RepeatWrapping,
  RGBAFormat,
  UnsignedByteType,
} from 'three';
import { type PackedLevel, packedLayerCount } from './packHatchImages.js';

/**
 * The texture of a tonal art map: packed hatch images (`packHatchImages`) as an RGBA array texture whose mip levels are
 * the drawn ones.
 *
 * It is a `CompressedArrayTexture` although nothing is compressed: this is three's only array texture that uploads given mip
 * levels. Anisotropy stays 1: on slanting surfaces it would average finer levels to grey, where the drawn coarser level
 * keeps its strokes black.
 */
export class TonalArtMapTexture extends CompressedArrayTexture {
  constructor(levels: readonly PackedLevel[], tones: number) {
    const size = levels[0].size;
    super(
      levels.map(({ data, size: side }) => ({ data, width: side, height: side })),
      size,
      size,
      packedLayerCount(tones),
      // The types allow compressed formats only; the renderer accepts this one too.
      RGBAFormat as unknown as CompressedPixelFormat,
      UnsignedByteType,
    );
    this.name = 'TonalArtMap';
    this.colorSpace = NoColorSpace;
    this.wrapS = RepeatWrapping;
    this.wrapT = RepeatWrapping;
    this.magFilter = LinearFilter;
    this.minFilter = levels.length > 1 ? LinearMipmapLinearFilter : LinearFilter;
    this.anisotropy = 1;
    this.needsUpdate = true;
  }
}
