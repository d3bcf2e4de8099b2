/** The key in a material's `userData` that says that it paints nothing but small parts. */
export const SMALL_PARTS = 'hatchingSmallParts';

/** The size of a part, as a share of that of the whole, below which it is seen as about four line spacings. */
const SHARE = 0.05;
/** The number of small parts from which on they are many. */
const MANY = 24;

/**
 * Which of many parts are so small that strokes cannot show their values, as stones of a ring and links of a chain; none if they are few.
 *
 * @param sizes diagonals of the parts
 * @param whole the diagonal of all of them together
 * @param counts how many parts each size stands for; 1 if left out
 */
export function smallAmong(sizes: readonly number[], whole: number, counts?: readonly number[]): boolean[] {
  const isSmall = sizes.map((size) => size < SHARE * whole);
  const count = isSmall.reduce((sum, small, i) => sum + (small ? (counts?.[i] ?? 1) : 0), 0);
  return count >= MANY ? isSmall : isSmall.fill(false);
}
