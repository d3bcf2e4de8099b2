/**
 * The parts of a title of the table, which an `…` separates.
 *
 * @param {string | undefined} title
 * @returns {string[]}
 */
export const titleParts = (title) =>
  (title ?? '')
    .split('…')
    .map((part) => part.trim())
    .filter((part) => part !== '');

/**
 * The pattern by which the runners find the tests of a title.
 *
 * @param {string | undefined} title
 */
export const titlePattern = (title) =>
  titleParts(title)
    .map((part) => part.replace(/[\\^$.*+?()[\]{}|]/g, '\\$&'))
    .join('.*');
