let hasWarned = false;

/**
 * Warns once on a page of an element that comes into view and never had a `src`. One whose `src` was taken away is meant to be empty.
 *
 * @param hadSource whether the element has had a `src` before
 */
export function warnOfMissingSource(hadSource: boolean): void {
  if (hadSource || hasWarned) return;
  hasWarned = true;
  console.warn('<hatched-model>: there is no src, so nothing is shown. Set src to the address of a glTF or GLB file.');
}
