/** A random unique id. `crypto.randomUUID` is missing in pages that are not served over HTTPS. */
export const newId = (): string =>
  [...crypto.getRandomValues(new Uint32Array(4))].map((part) => part.toString(36)).join('-');
