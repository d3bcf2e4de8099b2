/**
 * Divides paths in order where a pen has to be filled again.
 *
 * @param most the greatest length that is drawn between, millimetres; a longer path stays whole. Null for no limit
 */
export function refills<Path extends { length: number }>(paths: readonly Path[], most: number | null): Path[][] {
  if (most === null) return [[...paths]];
  const runs: Path[][] = [[]];
  let drawn = 0;
  for (const path of paths) {
    if (drawn > 0 && drawn + path.length > most) {
      runs.push([]);
      drawn = 0;
    }
    runs[runs.length - 1].push(path);
    drawn += path.length;
  }
  return runs;
}
