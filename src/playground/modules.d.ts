/** The Stanford bunny as nested arrays. The package has no types of its own. */
declare module 'bunny' {
  export const positions: [number, number, number][];
  export const cells: [number, number, number][];
}

/** The low-poly bust. The package has no types of its own. */
declare module 'snowden/lo.js' {
  export const positions: [number, number, number][];
  export const cells: [number, number, number][];
}

/** The functions of `models` that make forms, as JavaScript for copied code. Written by the build: see tools/building/formSources.ts. */
declare module 'virtual:form-sources' {
  /** The JavaScript of a model function, with everything it calls. */
  export interface FormSource {
    /** Import declarations, except those from `three`. */
    imports: string[];
    /** Its imports from `three`. */
    classes: string[];
    /** Declarations, among them the function. */
    code: string;
  }
  const sources: Readonly<
    Record<
      | ('teapot' | 'sphere' | 'shell' | 'vase' | 'column' | 'gears' | 'landscape' | 'knot')
      | ('makeFish' | 'makeHouse' | 'makeDrapery' | 'makeStairs' | 'makeRoom' | 'makeStreet' | 'makeFox'),
      FormSource
    >
  >;
  export default sources;
}

/** The URL of a model's ambient occlusion; undefined if none was baked. See tools/building/occlusionAhead.ts. */
declare module '*?occlusion' {
  const url: string | undefined;
  export default url;
}
