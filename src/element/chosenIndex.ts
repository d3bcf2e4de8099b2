/**
 * The index of the item that an attribute selects.
 *
 * @param kind the kind of the items, for error messages
 * @param wanted a name, or a number from 1 on
 * @throws Error that lists all items, if none is selected
 */
export function chosenIndex(kind: string, names: readonly (readonly string[])[], wanted: string): number {
  const named = names.findIndex((all) => all.includes(wanted));
  if (named !== -1) return named;
  const number = Number(wanted);
  if (Number.isInteger(number) && number >= 1 && number <= names.length) return number - 1;
  const known = names.map(([first]) => first).join(', ');
  throw new Error(`The model has no ${kind} "${wanted}". ${known ? `There are ${known}.` : 'It has none.'}`);
}
