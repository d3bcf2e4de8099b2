/** Options for drawing large meshes with no more triangles than can be seen. */
export interface DetailOptions {
  /**
   * The address of meshoptimizer's simplifier, which is not part of this library: install `meshoptimizer`, and let your bundler provide
   * the address of its file. With Vite:
   *
   *     import simplifier from 'meshoptimizer/simplifier?url';
   *
   * In a page without a bundler `import.meta.resolve('meshoptimizer/simplifier')` is the address that the import map gives.
   */
  simplifier: string | URL;
}

/** @throws TypeError that names the remedy */
export function checkDetail(detail: DetailOptions): void {
  const { simplifier } = Object(detail) as Partial<DetailOptions>;
  if (simplifier instanceof URL || (typeof simplifier === 'string' && simplifier !== '')) return;
  throw new TypeError(
    'applyHatching: detail must be an object whose simplifier is the address of meshoptimizer/simplifier, or left out.',
  );
}
