/** The part of meshoptimizer's `MeshoptSimplifier` used here. */
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

const loaded = /* @__PURE__ */ new Map<string, Simplifier>();

/**
 * Loads meshoptimizer's simplifier in this thread, once. It is not part of this library: users of levels of detail install it.
 *
 * @param address the URL of its module, absolute in a browser
 * @throws Error with the remedy, if there is none
 */
export async function loadSimplifier(address: string): Promise<void> {
  if (loaded.has(address)) return;
  let found: { MeshoptSimplifier?: Simplifier };
  try {
    found = await import(/* @vite-ignore */ /* webpackIgnore: true */ address);
  } catch (error) {
    throw new Error(
      `meshoptimizer could not be loaded from ${address} (${(error as Error).message}). Install meshoptimizer, and pass the address of its simplifier.`,
    );
  }
  const simplifier = found.MeshoptSimplifier;
  if (typeof simplifier?.simplifyWithAttributes !== 'function') {
    throw new Error(`${address} is not meshoptimizer's simplifier. It takes meshoptimizer 1.0 or newer.`);
  }
  await simplifier.ready;
  loaded.set(address, simplifier);
}

/** The simplifier loaded from a URL. @throws Error if none was */
export function simplifierOf(address: string): Simplifier {
  const simplifier = loaded.get(address);
  if (!simplifier) throw new Error(`The simplifier of ${address} is not loaded.`);
  return simplifier;
}
