/** A name that nothing else has. Pages that do not come over HTTPS have no `randomUUID`. */
export const newId = (): string =>
  [...crypto.getRandomValues(new Uint32Array(4))].map((part) => part.toString(36)).join('-');
