import type { Color, Vector2, Vector3 } from 'three';

/** The value of a property as its default is written: colours as numbers, vectors as arrays. */
export function plainValue(value: unknown): unknown {
  if ((value as Color | null)?.isColor) return (value as Color).getHex();
  if ((value as Vector2 | null)?.isVector2) return (value as Vector2).toArray();
  if ((value as Vector3 | null)?.isVector3) return (value as Vector3).toArray();
  return value;
}
