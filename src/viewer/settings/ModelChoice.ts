/** What is chosen of what the file of a model offers, by indices from 0 on. */
export interface ModelChoice {
  /** Of the variants of its materials; undefined for the materials that it has without one. */
  readonly variant: number | undefined;
  /** Of its clips; undefined for the first. */
  readonly clip: number | undefined;
}

export const NO_CHOICE: ModelChoice = { variant: undefined, clip: undefined };

export const isSameChoice = (a: ModelChoice, b: ModelChoice): boolean => a.variant === b.variant && a.clip === b.clip;
