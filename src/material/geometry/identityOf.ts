const identity = Symbol('three-hatching identity');

/**
 * Returns an object that is the same for `thing` and for every proxy of it, as a key for weak maps and sets. Frameworks such as
 * Vue return proxies of the objects they hold (`ref(mesh)`), so a mesh may be passed in both forms. The key lives as long as
 * `thing`.
 *
 * The key is stored on `thing` under a symbol. A function returns it, since proxies wrap objects but not what functions return.
 * An object that is not extensible is its own key. Allocates nothing once a thing has its key.
 */
export function identityOf(thing: object): object {
  const known = (thing as { [identity]?: () => object })[identity];
  if (known) return known();
  return Object.isExtensible(thing) ? giveIdentity(thing) : thing;
}

/** A separate function, because variables that a closure captures are allocated at every call of the enclosing function. */
function giveIdentity(thing: object): object {
  const made = {};
  Object.defineProperty(thing, identity, { value: () => made });
  return made;
}
