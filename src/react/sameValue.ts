import { useState } from 'react';

/**
 * Whether two options have the same value. Numbers, strings, arrays and plain objects are compared by content, other objects by
 * identity. Two functions count as the same, since components create theirs anew with each render.
 */
export function sameValue(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true;
  if (typeof a === 'function' && typeof b === 'function') return true;
  if (Array.isArray(a) && Array.isArray(b)) {
    return a.length === b.length && a.every((value, i) => sameValue(value, b[i]));
  }
  if (!isPlain(a) || !isPlain(b)) return false;
  return namesOf(a, b).every((name) => sameValue(a[name], b[name]));
}

/** The names of the properties that at least one of two objects has. */
export const namesOf = (a: object, b: object): string[] => [...new Set([...Object.keys(a), ...Object.keys(b)])];

/** Whether a value is an object that was written as a literal. */
export const isPlain = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype;

/** Returns the same object as long as its content is equal, for objects that components create with each render. */
export function useStable<Value>(value: Value): Value {
  const [stable, setStable] = useState(value);
  if (stable === value || sameValue(stable, value)) return stable;
  setStable(() => value);
  return value;
}
