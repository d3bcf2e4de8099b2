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

/** One level of a packed map: `layers` images of size × size RGBA texels, one after the other. */
export interface PackedLevel {
  size: number;
  data: Uint8Array;
}

/** The number of layers of a packed map. A layer holds four tones, of which it shares one with the next layer. */
export const packedLayerCount = (tones: number): number => Math.ceil((tones - 1) / 3);

/**
 * Packs hatch images into RGBA layers that overlap by one tone: layer l, channel c holds tone min(3l + c, tones − 1). The two images
 * that any tone lies between are then in the same texel, so one fetch reads both: one fetch per triangle, or four for a triangle and
 * its three neighbours.
 *
 * @param images `images[tone][level]`, (size / 2^level)² bytes each
 */
export function packHatchImages(size: number, images: readonly (readonly ArrayLike<number>[])[]): PackedLevel[] {
  const tones = images.length;
  const layers = packedLayerCount(tones);
  return images[0].map((_, level) => {
    const levelSize = size >> level;
    const texels = levelSize * levelSize;
    const data = new Uint8Array(texels * layers * 4);
    for (let layer = 0; layer < layers; layer++) {
      for (let channel = 0; channel < 4; channel++) {
        const image = images[Math.min(3 * layer + channel, tones - 1)][level];
        for (let texel = 0, at = 4 * layer * texels + channel; texel < texels; texel++, at += 4)
          data[at] = image[texel];
      }
    }
    return { size: levelSize, data };
  });
}

/** The bytes of one hatch image, unpacked from its level. */
export function unpackHatchImage(level: PackedLevel, tone: number): Uint8Array {
  const texels = level.size * level.size;
  const layer = tone === 0 ? 0 : Math.floor((tone - 1) / 3);
  const image = new Uint8Array(texels);
  for (let texel = 0, at = 4 * layer * texels + (tone - 3 * layer); texel < texels; texel++, at += 4) {
    image[texel] = level.data[at];
  }
  return image;
}

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
