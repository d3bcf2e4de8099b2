import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import type { TonalArtMap } from '../tam/TonalArtMap.js';
import type { HatchingMap } from './checkTonalArtMap.js';

/** The shared map of each style that was asked for; null until the code that draws it is there, and where it could not be fetched. */
const maps = /* @__PURE__ */ new Map<StrokeStyleName, TonalArtMap | null>();

/**
 * The map of a style that all materials share, or null as long as there is none. The first call for a style fetches the code of maps,
 * which a material needs for nothing else, and has it drawn.
 */
export function sharedMap(style: StrokeStyleName): TonalArtMap | null {
  const map = maps.get(style);
  if (map !== undefined) return map;
  maps.set(style, null);
  fetchSharedMap(style).catch((error: unknown) => {
    console.error(
      `HatchingMaterial: the code that draws tonal art maps could not be fetched (${error instanceof Error ? error.message : String(error)}); surfaces stay blank paper. Serve all files of the package.`,
    );
  });
  return null;
}

/** Resolves when a material with this map can be drawn. Rejects if it cannot be drawn. */
export async function mapIsReady(map: HatchingMap): Promise<void> {
  await (typeof map === 'string' ? await fetchSharedMap(map) : map)?.ready;
}

/** The same map as soon as its code is there; it may still be being drawn. */
async function fetchSharedMap(style: StrokeStyleName): Promise<TonalArtMap> {
  const { TonalArtMap } = await import('../tam/TonalArtMap.js');
  const map = TonalArtMap.shared(style);
  maps.set(style, map);
  return map;
}
