/** Returns a random number in [0, 1). */
export type Random = () => number;

/**
 * Creates a seeded generator: the same seed gives the same numbers on every machine.
 *
 * It is a Weyl sequence with a 32-bit finaliser ("splitmix32"; the constants are those of Chris Wellons' "lowbias32").
 *
 * @param seed any finite number; it is used modulo 2³²
 */
export function random(seed: number): Random {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x9e3779b9) >>> 0;
    let bits = state;
    bits = Math.imul(bits ^ (bits >>> 16), 0x21f0aaad);
    bits = Math.imul(bits ^ (bits >>> 15), 0x735a2d97);
    return ((bits ^ (bits >>> 15)) >>> 0) / 4294967296;
  };
}
