/** What is selected of a model's file, by indices from 0. */
export interface ModelChoice {
  /** Index of the material variant; undefined for the file's default materials. */
  readonly variant: number | undefined;
  /** Index of the clip; undefined for the first. */
  readonly clip: number | undefined;
}

export const NO_CHOICE: ModelChoice = { variant: undefined, clip: undefined };

export const isSameChoice = (a: ModelChoice, b: ModelChoice): boolean => a.variant === b.variant && a.clip === b.clip;
