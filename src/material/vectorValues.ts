import { Vector2, Vector3 } from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_PROPERTIES } from '../look/hatchingProperties.js';

/** A Vector2, or an array of two numbers. */
export type Vector2Like = Vector2 | readonly [number, number];

/** Whether a value is a Vector2, or an array, of two finite numbers. */
export function isVector2Like(value: unknown): boolean {
  const [x, y] = Array.isArray(value) ? value : [(value as Vector2 | null)?.x, (value as Vector2 | null)?.y];
  return Number.isFinite(x) && Number.isFinite(y) && (!Array.isArray(value) || value.length === 2);
}

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
