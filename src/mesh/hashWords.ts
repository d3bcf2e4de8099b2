/**
 * MurmurHash3 (Austin Appleby, public domain) of three words. The coordinates of a regular grid differ only in a few high
 * bits. The final mix carries these into the low bits, which the mask of a hash table keeps.
 */
export function hashWords(x: number, y: number, z: number): number {
  let h = mix(mix(mix(0x9747b28c, x), y), z);
  h ^= h >>> 16;
  h = Math.imul(h, 0x85ebca6b);
  h ^= h >>> 13;
  h = Math.imul(h, 0xc2b2ae35);
  return h ^ (h >>> 16);
}

function mix(h: number, word: number): number {
  let k = Math.imul(word, 0xcc9e2d51);
  k = (k << 15) | (k >>> 17);
  h ^= Math.imul(k, 0x1b873593);
  h = (h << 13) | (h >>> 19);
  return (Math.imul(h, 5) + 0xe6546b64) | 0;
}
