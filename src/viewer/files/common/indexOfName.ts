/**
 * The index of a name among others, in capitals or not where none is written the same, or of a number from 1 on if none is called so; −1 if
 * there is none.
 */
export function indexOfName(names: readonly string[], wanted: string): number {
  const plain = wanted.trim().toLowerCase();
  for (const named of [names.indexOf(wanted), names.findIndex((name) => name.trim().toLowerCase() === plain)])
    if (named !== -1) return named;
  const number = Number(wanted);
  return Number.isInteger(number) && number >= 1 && number <= names.length ? number - 1 : -1;
}
