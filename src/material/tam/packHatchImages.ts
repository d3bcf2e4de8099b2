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
