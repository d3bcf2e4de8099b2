import type { NumberRange } from '../look/HatchingProperty.js';

/**
 * @param words that may stand in place of a number, for the message
 * @throws RangeError unless `value` is a finite number in `range`, naming the property and the range
 */
export function checkNumber(
  name: string,
  value: unknown,
  range: NumberRange = {},
  owner = 'HatchingMaterial',
  words: readonly string[] = [],
): number {
  const { above = -Infinity, from = -Infinity, to = Infinity } = range;
  if (typeof value === 'number' && Number.isFinite(value) && value > above && value >= from && value <= to)
    return value;
  const span = Object.keys(range).length > 0 ? ` in ${describeRange(range)}` : '';
  const others = words.map((word) => ` or '${word}'`).join('');
  throw new RangeError(`${owner}.${name}: ${String(value)} is not a number${span}${others}.`);
}

/** The range in mathematical notation, such as `(0, ∞)`. */
export function describeRange({ above, from, to }: NumberRange): string {
  const start = above !== undefined ? `(${above}` : from !== undefined ? `[${from}` : '(−∞';
  return `${start}, ${to === undefined ? '∞)' : `${to}]`}`;
}
