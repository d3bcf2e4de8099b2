/** To three decimals, as code that is copied shows numbers. */
export const round = (value: number): number => Math.round(value * 1000) / 1000;
