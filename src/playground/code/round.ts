/** Rounds to three decimals, as numbers stand in copied code. */
export const round = (value: number): number => Math.round(value * 1000) / 1000;
