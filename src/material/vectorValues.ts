import { Vector2 } from 'three';
import type { HatchingProperty } from './facts/HatchingProperty.js';
import { HATCHING_PROPERTIES } from './facts/hatchingProperties.js';

/** A vector, or its two numbers. */
export type Vector2Like = Vector2 | readonly [number, number];

/** Whether a value is a vector, or an array, of two finite numbers. */
export function isVector2Like(value: unknown): boolean {
  const [x, y] = Array.isArray(value) ? value : [(value as Vector2 | null)?.x, (value as Vector2 | null)?.y];
  return Number.isFinite(x) && Number.isFinite(y) && (!Array.isArray(value) || value.length === 2);
}

/** Parameters in which vectors that are given as arrays are vectors, which three.js copies. */
export function withVectors<Parameters extends object>(parameters: Parameters): Parameters {
  const arrays = Object.entries(parameters).filter(([name, value]) => Array.isArray(value) && isVectorProperty(name));
  if (arrays.length === 0) return parameters;
  return { ...parameters, ...Object.fromEntries(arrays.map(([name, [x, y]]) => [name, new Vector2(x, y)])) };
}

function isVectorProperty(name: string): boolean {
  const properties: Readonly<Record<string, HatchingProperty>> = HATCHING_PROPERTIES;
  return Object.hasOwn(properties, name) && properties[name].kind === 'vector2';
}
