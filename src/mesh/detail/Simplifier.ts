/** What is used of meshoptimizer's `MeshoptSimplifier`. */
export interface Simplifier {
  /** Resolves when its code is compiled. */
  ready: Promise<void>;
  simplifyWithAttributes(
    indices: Uint32Array,
    positions: Float32Array,
    positionStride: number,
    attributes: Float32Array,
    attributeStride: number,
    attributeWeights: number[],
    vertexLock: Uint8Array | null,
    targetIndexCount: number,
    targetError: number,
    flags?: ('LockBorder' | 'ErrorAbsolute' | 'Permissive')[],
  ): [indices: Uint32Array, error: number];
}
