/**
 * Returns the element with an id.
 *
 * @throws Error if the HTML has none
 */
export function findElement(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`findElement: the page has no element with the id "${id}"; add it back to its HTML.`);
  return element;
}
