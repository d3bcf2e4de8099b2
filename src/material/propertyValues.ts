import { Vector2, Vector3 } from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_PROPERTIES } from '../look/hatchingProperties.js';
import { STROKE_STYLE_NAMES, type StrokeStyleName } from '../strokes/strokeStyleNames.js';
import { isPromise } from './diagnostics/warn.js';
import type { TonalArtMap } from './tam/TonalArtMap.js';

/** A Vector2, or an array of two numbers. */
export type Vector2Like = Vector2 | readonly [number, number];

/** Whether a value is a Vector2, or an array, of two finite numbers. */
export function isVector2Like(value: unknown): boolean {
  const [x, y] = Array.isArray(value) ? value : [(value as Vector2 | null)?.x, (value as Vector2 | null)?.y];
  return Number.isFinite(x) && Number.isFinite(y) && (!Array.isArray(value) || value.length === 2);
}

/** The given Vector2, or a new one from an array. */
export const toVector2 = (value: Vector2Like): Vector2 => ('x' in value ? value : new Vector2(...value));

/** A Vector3, or an array of three numbers. */
export type Vector3Like = Vector3 | readonly [number, number, number];

/** Whether a value is a Vector3, or an array, of three finite numbers. */
export function isVector3Like(value: unknown): boolean {
  if (Array.isArray(value)) return value.length === 3 && value.every(Number.isFinite);
  const point = value as Partial<Vector3> | null;
  return point?.isVector3 === true && Number.isFinite(point.x! + point.y! + point.z!);
}

/** The given Vector3, or a new one from an array. */
export const toPoint = (value: Vector3Like): Vector3 => ('x' in value ? value : new Vector3(...value));

/** The parameters with arrays replaced by vectors, which three.js copies. */
export function withVectors<Parameters extends object>(parameters: Parameters): Parameters {
  const arrays = Object.entries(parameters).filter(([name, value]) => Array.isArray(value) && isVectorProperty(name));
  if (arrays.length === 0) return parameters;
  return { ...parameters, ...Object.fromEntries(arrays.map(([name, [x, y]]) => [name, new Vector2(x, y)])) };
}

function isVectorProperty(name: string): boolean {
  const properties: Readonly<Record<string, HatchingProperty>> = HATCHING_PROPERTIES;
  return Object.hasOwn(properties, name) && properties[name].kind === 'vector2';
}

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
