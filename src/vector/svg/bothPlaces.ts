/** For each point the first one at the same place in both of two lists. */
export function bothPlaces(one: Uint32Array, other: Uint32Array): Uint32Array {
  const known = new Map<number, number>();
  return one.map((place, point) => {
    const key = place * 2 ** 26 + other[point];
    const first = known.get(key) ?? point;
    if (first === point) known.set(key, point);
    return first;
  });
}
