/** A colour or vector of three.js, by what it is known by. */
interface ThreeValue {
  isColor?: boolean;
  isVector2?: boolean;
  isVector3?: boolean;
  getHex(): number;
  toArray(): number[];
}

/** The value of a property as its default is written: colours as numbers, vectors as arrays. */
export function plainValue(value: unknown): unknown {
  const known = value as ThreeValue | null | undefined;
  if (known?.isColor) return known.getHex();
  if (known?.isVector2 || known?.isVector3) return known.toArray();
  return value;
}
