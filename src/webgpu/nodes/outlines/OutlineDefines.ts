/** The choices that the program of outlines depends on, named as the GLSL defines. */
export interface OutlineDefines {
  /** Whether hidden outlines are drawn, instead of visible ones. */
  readonly HIDDEN: boolean;
  readonly TOOTH: boolean;
  readonly WOBBLE: boolean;
}
