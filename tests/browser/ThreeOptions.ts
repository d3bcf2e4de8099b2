/** Options of a whole project of Playwright's configuration. */
export interface ThreeOptions {
  /** The package that the pages get as three.js, if it is not `three`. */
  three: string | undefined;
}
