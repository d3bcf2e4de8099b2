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
 * It is a `CompressedArrayTexture` although nothing is compressed: no other array texture of three.js uploads its own mip levels.
 * Anisotropy stays 1: on slanted surfaces it would average finer levels to grey, whereas the coarser level keeps its strokes black.
 */
export class TonalArtMapTexture extends CompressedArrayTexture {
  /**
   * @param size texels per side of level 0
   * @param levels the number of levels
   */
  constructor(size: number, levels: number, tones: number) {
    super(
      [],
      size,
      size,
      packedLayerCount(tones),
      // The types only allow compressed formats, but the renderer accepts this format too.
      RGBAFormat as unknown as CompressedPixelFormat,
      UnsignedByteType,
    );
    this.name = 'TonalArtMap';
    this.colorSpace = NoColorSpace;
    this.wrapS = RepeatWrapping;
    this.wrapT = RepeatWrapping;
    this.magFilter = LinearFilter;
    this.minFilter = levels > 1 ? LinearMipmapLinearFilter : LinearFilter;
    this.anisotropy = 1;
  }

  /**
   * Sets the images, which the renderer uploads in the next frame that draws with them.
   *
   * @internal
   */
  fill(levels: readonly PackedLevel[]): void {
    this.mipmaps = levels.map(({ data, size }) => ({ data, width: size, height: size }));
    this.needsUpdate = true;
  }
}
