import { warn } from './diagnostics/warn.js';
import { identityOf } from './geometry/identityOf.js';
import type { TonalArtMap } from './tam/TonalArtMap.js';

/** The identities of maps that were reported as too large. */
const reportedMaps = new WeakSet<object>();

/**
 * Returns the map if it is ready and the device can hold its textures, otherwise null: a texture that is too large would draw
 * everything black. Reports a map that is too large once.
 *
 * @param usesThresholds whether the threshold texture is used too; it is about twice as wide as the map
 * @param maxTextureSize the device's limit, in texels
 */
export function fittingMap(
  map: TonalArtMap | null,
  usesThresholds: boolean,
  maxTextureSize: number,
): TonalArtMap | null {
  if (!map?.isReady) return null;
  const width = usesThresholds ? map.thresholdTexture.image.width : map.size;
  if (width <= maxTextureSize) return map;
  const identity = identityOf(map);
  if (!reportedMaps.has(identity)) {
    reportedMaps.add(identity);
    warn(
      `HatchingMaterial.tonalArtMap: a map of ${map.size} texels per side needs a texture ${width} texels wide, but this device allows ${maxTextureSize}. The surface stays blank paper; give it a smaller map.`,
      'error',
    );
  }
  return null;
}
