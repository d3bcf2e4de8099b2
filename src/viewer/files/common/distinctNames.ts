/**
 * Names by which each of several things can be chosen: those without one are numbered, as `Clip 2`, and so are those after the first that have
 * the same.
 *
 * @param kind what things without a name are called
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
