const identity = Symbol('three-hatching identity');

/**
 * An object that stands for `thing` and for every proxy of it, to key weak maps and sets by: frameworks such as Vue hand out
 * proxies of what they keep (`ref(mesh)`), and one mesh may come in both forms. Lives as long as `thing`.
 *
 * It is kept on `thing`, hidden, and behind a function, which proxies pass on as it is while they wrap objects. What cannot be
 * extended stands for itself.
 */
export function identityOf(thing: object): object {
  const known = (thing as { [identity]?: () => object })[identity];
  if (known) return known();
  if (!Object.isExtensible(thing)) return thing;
  const made = {};
  Object.defineProperty(thing, identity, { value: () => made });
  return made;
}
