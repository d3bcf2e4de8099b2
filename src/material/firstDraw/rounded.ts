/** A number with two significant digits, for messages. */
export const rounded = (value: number): string => String(Number(value.toPrecision(2)));
