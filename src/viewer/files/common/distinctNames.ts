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
