/** The index of a name in a list: by exact match, or else regardless of case, or else as a number counted from 1; −1 if there is none. */
export function indexOfName(names: readonly string[], wanted: string): number {
  const plain = wanted.trim().toLowerCase();
  for (const named of [names.indexOf(wanted), names.findIndex((name) => name.trim().toLowerCase() === plain)])
    if (named !== -1) return named;
  const number = Number(wanted);
  return Number.isInteger(number) && number >= 1 && number <= names.length ? number - 1 : -1;
}
