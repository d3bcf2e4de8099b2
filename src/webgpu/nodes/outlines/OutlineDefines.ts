/** What chooses the program of outlines, as the defines of those in GLSL do. */
export interface OutlineDefines {
  /** Whether outlines are drawn that a surface hides, instead of those that are seen. */
  readonly HIDDEN: boolean;
  readonly TOOTH: boolean;
  readonly WOBBLE: boolean;
}
