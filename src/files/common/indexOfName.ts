/** The index of a name among others, or of a number from 1 on if none is called so; −1 if there is none. */
export function indexOfName(names: readonly string[], wanted: string): number {
  const named = names.indexOf(wanted);
  if (named !== -1) return named;
  const number = Number(wanted);
  return Number.isInteger(number) && number >= 1 && number <= names.length ? number - 1 : -1;
}
