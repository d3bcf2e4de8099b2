import { useState } from 'react';
import { sameValue } from './sameValue.js';

/** Returns the same object as long as its content is equal, for objects that components create with each render. */
export function useStable<Value>(value: Value): Value {
  const [stable, setStable] = useState(value);
  if (stable === value || sameValue(stable, value)) return stable;
  setStable(() => value);
  return value;
}
