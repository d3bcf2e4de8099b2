import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import { warn } from './diagnostics/warn.js';
import { identityOf } from './geometry/identityOf.js';
import type { HatchingMap } from './propertyValues.js';
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

/** The shared map of each style in use; null until the code of maps has loaded, and after a failure. */
const maps = /* @__PURE__ */ new Map<StrokeStyleName, TonalArtMap | null>();

/** The pause after a failure before the next try, in milliseconds: materials ask in every frame. */
const RETRY_MS = 5000;

/**
 * The map of a style that all materials share, or null until it exists. The first call for a style fetches the code of maps and has the
 * map drawn.
 */
export function sharedMap(style: StrokeStyleName): TonalArtMap | null {
  const map = maps.get(style);
  if (map !== undefined) return map;
  maps.set(style, null);
  draw(style).catch((error: unknown) => {
    const reason = error instanceof Error ? error.message : String(error);
    console.error(
      `HatchingMaterial: the map of the style "${style}" could not be drawn (${reason}); surfaces are blank paper until it is tried again. Serve all files of the package.`,
    );
    setTimeout(() => maps.delete(style), RETRY_MS);
  });
  return null;
}

/** Resolves when a material can draw with this map. Rejects if the map cannot be drawn. */
export async function mapIsReady(map: HatchingMap): Promise<void> {
  const chosen = typeof map === 'string' ? await fetchMap(map) : map;
  await chosen?.ready;
  // The next frame draws with the map.
  if (chosen && typeof map === 'string') maps.set(map, chosen);
}

/** Gives the map to materials as soon as its code has loaded, and resolves when it is drawn. */
async function draw(style: StrokeStyleName): Promise<void> {
  const map = await fetchMap(style);
  maps.set(style, map);
  await map.ready;
}

async function fetchMap(style: StrokeStyleName): Promise<TonalArtMap> {
  const { TonalArtMap } = await import('./tam/TonalArtMap.js');
  return TonalArtMap.shared(style);
}
