import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import type { HatchingMap } from './checkTonalArtMap.js';
import type { TonalArtMap } from './tam/TonalArtMap.js';

/** The shared map of each style that was drawn with; null until the code of maps is there, and after a failure. */
const maps = /* @__PURE__ */ new Map<StrokeStyleName, TonalArtMap | null>();

/** Whoever draws asks in every frame; so many milliseconds after a failure it is tried again. */
const PAUSE = 5000;

/**
 * The map of a style that all materials share, or null as long as there is none. The first call for a style fetches the code of maps,
 * which a material needs for nothing else, and has it drawn.
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
    setTimeout(() => maps.delete(style), PAUSE);
  });
  return null;
}

/** Resolves when a material with this map can be drawn. Rejects if it cannot be drawn. */
export async function mapIsReady(map: HatchingMap): Promise<void> {
  const chosen = typeof map === 'string' ? await fetchMap(map) : map;
  await chosen?.ready;
  // The next frame draws with it.
  if (chosen && typeof map === 'string') maps.set(map, chosen);
}

/** Gives the map to materials as soon as its code is there, and resolves when it is drawn. */
async function draw(style: StrokeStyleName): Promise<void> {
  const map = await fetchMap(style);
  maps.set(style, map);
  await map.ready;
}

async function fetchMap(style: StrokeStyleName): Promise<TonalArtMap> {
  const { TonalArtMap } = await import('./tam/TonalArtMap.js');
  return TonalArtMap.shared(style);
}
