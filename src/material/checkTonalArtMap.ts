import type { TonalArtMap } from '../tam/TonalArtMap.js';

/** @throws TypeError unless `value` is a TonalArtMap or null */
export function checkTonalArtMap(value: TonalArtMap | null): TonalArtMap | null {
  if (value === null || (value as Partial<TonalArtMap> | undefined)?.texture?.isTexture) return value;
  throw new TypeError(
    `HatchingMaterial.tonalArtMap: ${String(value)} is no TonalArtMap; await TonalArtMap.generate() gives one, null stands for none.`,
  );
}
