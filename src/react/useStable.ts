import { useState } from 'react';
import { sameValue } from './sameValue.js';

/** The same object as long as what it holds is the same, for objects that components write anew each time they are rendered. */
export function useStable<Value>(value: Value): Value {
  const [stable, setStable] = useState(value);
  if (stable === value || sameValue(stable, value)) return stable;
  setStable(() => value);
  return value;
}
