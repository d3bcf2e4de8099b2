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
  /** JavaScript that a model is made by, with all that it calls. */
  export interface FormSource {
    /** Import declarations, but for those from `three`. */
    imports: string[];
    /** What it takes from `three`. */
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

/** The address of the ambient occlusion of a model; undefined where none was baked. See tools/building/occlusionAhead.ts. */
declare module '*?occlusion' {
  const url: string | undefined;
  export default url;
}
