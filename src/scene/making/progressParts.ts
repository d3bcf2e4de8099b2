/**
 * Divides a progress among concurrent parts: it is the weighted sum of theirs.
 *
 * @param shares the share of each part; together they are 1
 * @returns a listener for each part, or undefined if there is none for the whole
 */
export function progressParts<Shares extends readonly number[]>(
  onProgress: ((progress: number) => void) | undefined,
  shares: readonly [...Shares],
): { [Index in keyof Shares]: ((progress: number) => void) | undefined } {
  const missing = shares.slice();
  const listeners = shares.map((share, part) => {
    if (!onProgress) return undefined;
    return (progress: number): void => {
      missing[part] = share * (1 - progress);
      // The sum of what is missing ends at exactly 0.
      const sum = missing.reduce((all, one) => all + one, 0);
      onProgress(Math.max(0, 1 - sum));
    };
  });
  return listeners as { [Index in keyof Shares]: ((progress: number) => void) | undefined };
}
