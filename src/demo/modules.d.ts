/** The Stanford bunny as nested arrays. The package has no types of its own. */
declare module 'bunny' {
  export const positions: [number, number, number][];
  export const cells: [number, number, number][];
}

/** The bust, in few triangles. The package has no types of its own. */
declare module 'snowden/lo.js' {
  export const positions: [number, number, number][];
  export const cells: [number, number, number][];
}
