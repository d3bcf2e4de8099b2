import type { TonalArtMap } from '../tam/TonalArtMap.js';

/** Whether a value is a TonalArtMap, also one from another copy of the library. */
export const isTonalArtMap = (value: unknown): value is TonalArtMap =>
  (value as Partial<TonalArtMap> | null | undefined)?.isTonalArtMap === true;

/** @throws TypeError unless `value` is a TonalArtMap or null */
export function checkTonalArtMap(value: TonalArtMap | null): TonalArtMap | null {
  if (value === null || isTonalArtMap(value)) return value;
  throw new TypeError(
    `HatchingMaterial.tonalArtMap: ${String(value)} is no TonalArtMap; TonalArtMap.draw() gives one, null stands for none.`,
  );
}
