import { STROKE_STYLE_NAMES, type StrokeStyleName } from '../strokes/strokeStyleNames.js';
import { isPromise } from './diagnostics/mustBeAwaited.js';
import type { TonalArtMap } from './tam/TonalArtMap.js';

/** Whether a value is a TonalArtMap, possibly from another copy of the library. */
export const isTonalArtMap = (value: unknown): value is TonalArtMap =>
  (value as Partial<TonalArtMap> | null | undefined)?.isTonalArtMap === true;

/** A map, the name of a style, whose shared map is used, or null for none. */
export type HatchingMap = TonalArtMap | StrokeStyleName | null;

/** @throws TypeError unless `value` is a TonalArtMap, the name of a style, or null */
export function checkHatchingMap(value: HatchingMap): HatchingMap {
  if (STROKE_STYLE_NAMES.includes(value as StrokeStyleName)) return value;
  if (typeof value !== 'string') return checkTonalArtMap(value);
  throw new TypeError(
    `HatchingMaterial.tonalArtMap: "${value}" is no style; use one of ${STROKE_STYLE_NAMES.join(', ')}, or a TonalArtMap.`,
  );
}

/** @throws TypeError unless `value` is a TonalArtMap or null */
export function checkTonalArtMap(value: TonalArtMap | null): TonalArtMap | null {
  if (value === null || isTonalArtMap(value)) return value;
  const fault = isPromise(value)
    ? 'a promise is no TonalArtMap; write await before it, or use TonalArtMap.draw().'
    : `${String(value)} is no TonalArtMap; TonalArtMap.draw() gives one, null stands for none.`;
  throw new TypeError(`HatchingMaterial.tonalArtMap: ${fault}`);
}
