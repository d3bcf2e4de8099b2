import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import type { HatchingMap } from './checkTonalArtMap.js';
import type { TonalArtMap } from './tam/TonalArtMap.js';

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
