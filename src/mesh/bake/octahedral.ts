const ONE = 0x7fff;

/**
 * Packs a unit vector into one word, as two normalised 16-bit integers. The vector is projected onto an octahedron whose lower
 * half is folded outwards (Cigolle et al., "A survey of efficient representations for independent unit vectors", 2014). The
 * error is at most 0.004°.
 */
export function octahedral(x: number, y: number, z: number): number {
  const sum = Math.abs(x) + Math.abs(y) + Math.abs(z) || 1;
  let u = x / sum;
  let v = y / sum;
  if (z < 0) {
    const folded = (1 - Math.abs(v)) * (u < 0 ? -1 : 1);
    v = (1 - Math.abs(u)) * (v < 0 ? -1 : 1);
    u = folded;
  }
  return (Math.round(u * ONE) & 0xffff) | ((Math.round(v * ONE) & 0xffff) << 16);
}

/** Unpacks the unit vector in `word` into `target`, at `offset`. */
export function readOctahedral(word: number, target: Float32Array, offset: number): void {
  let x = Math.max(((word << 16) >> 16) / ONE, -1);
  let y = Math.max((word >> 16) / ONE, -1);
  const z = 1 - Math.abs(x) - Math.abs(y);
  const below = Math.max(-z, 0);
  x += x >= 0 ? -below : below;
  y += y >= 0 ? -below : below;
  const length = Math.sqrt(x * x + y * y + z * z);
  target[offset] = x / length;
  target[offset + 1] = y / length;
  target[offset + 2] = z / length;
}
