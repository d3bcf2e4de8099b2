/**
 * Whether two options say the same: numbers, texts, arrays and plain objects by what they hold, anything else by being one. Two
 * functions count as the same, since components write theirs anew each time they are rendered.
 */
export function sameValue(one: unknown, other: unknown): boolean {
  if (Object.is(one, other)) return true;
  if (typeof one === 'function' && typeof other === 'function') return true;
  if (Array.isArray(one) && Array.isArray(other)) {
    return one.length === other.length && one.every((value, i) => sameValue(value, other[i]));
  }
  if (!isPlain(one) || !isPlain(other)) return false;
  return namesOf(one, other).every((name) => sameValue(one[name], other[name]));
}

/** The names that one of two objects has, or both. */
export const namesOf = (one: object, other: object): string[] => [
  ...new Set([...Object.keys(one), ...Object.keys(other)]),
];

const isPlain = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype;
