/**
 * The index of what is chosen among named things.
 *
 * @param kind of the things, for the sentence of an error
 * @param wanted a name, or a number from 1 on
 * @throws Error that names all, if there is no such thing
 */
export function chosenIndex(kind: string, names: readonly (readonly string[])[], wanted: string): number {
  const named = names.findIndex((all) => all.includes(wanted));
  if (named !== -1) return named;
  const number = Number(wanted);
  if (Number.isInteger(number) && number >= 1 && number <= names.length) return number - 1;
  const known = names.map(([first]) => first).join(', ');
  throw new Error(`The model has no ${kind} "${wanted}". ${known ? `There are ${known}.` : 'It has none.'}`);
}
