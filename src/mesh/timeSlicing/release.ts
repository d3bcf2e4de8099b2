/** TypeScript's library for this target does not know `transfer` yet. */
type Releasable = ArrayBufferLike & { transfer?(length: number): ArrayBuffer };

/**
 * Frees the memory of arrays at once, which are empty from then on. Otherwise it would be kept until the next garbage collection, which
 * comes late for memory outside of the heap: a bake then holds twice of what it uses. Does nothing in engines without
 * `ArrayBuffer.prototype.transfer`.
 */
export function release(...arrays: ArrayBufferView[]): void {
  for (const { buffer } of arrays as { buffer: Releasable }[]) if (buffer.byteLength > 0) buffer.transfer?.(0);
}
