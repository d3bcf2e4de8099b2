/**
 * Makes names distinct: missing names become a number, such as `Clip 2`, and repeated names get one too.
 *
 * @param kind the word for things without a name
 */
export function distinctNames(names: readonly (string | undefined)[], kind: string): string[] {
  const taken = new Map<string, number>();
  return names.map((given, i) => {
    const name = given || `${kind} ${i + 1}`;
    const before = taken.get(name) ?? 0;
    taken.set(name, before + 1);
    return before === 0 ? name : `${name} ${before + 1}`;
  });
}

/** The index of a name in a list: by exact match, or else regardless of case, or else as a number counted from 1; −1 if there is none. */
export function indexOfName(names: readonly string[], wanted: string): number {
  const plain = wanted.trim().toLowerCase();
  for (const named of [names.indexOf(wanted), names.findIndex((name) => name.trim().toLowerCase() === plain)])
    if (named !== -1) return named;
  const number = Number(wanted);
  return Number.isInteger(number) && number >= 1 && number <= names.length ? number - 1 : -1;
}
