/** What chooses the program of outlines, as the defines of those in GLSL do. */
export interface OutlineDefines {
  readonly WOBBLE: boolean;
}
