/** A number with two digits that count, for messages. */
export const rounded = (value: number): string => String(Number(value.toPrecision(2)));
