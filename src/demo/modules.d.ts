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

/** The functions of `models` that make forms, as JavaScript for copied code. The build writes them: see tools/building/formSources.ts. */
declare module 'virtual:form-sources' {
  const sources: Readonly<
    Record<
      'shell' | 'vase' | 'column' | 'gears' | 'landscape' | 'knot' | 'makeFish',
      import('../../tools/building/formSources.js').FormSource
    >
  >;
  export default sources;
}
