/** A link may be written by anyone: longer lists are not read. */
const MAX_INDICES = 100_000;

/** Indices in rising order as a short text: numbers from 1 on, runs of which are ranges, as `1-3,7`. */
export function writeRanges(indices: readonly number[]): string {
  const ranges: string[] = [];
  for (let i = 0; i < indices.length; ) {
    const first = indices[i] + 1;
    let last = first;
    for (i++; i < indices.length && indices[i] === last; i++) last++;
    ranges.push(first === last ? `${first}` : `${first}-${last}`);
  }
  return ranges.join(',');
}

/** The indices of a text that {@link writeRanges} wrote, in rising order. Anything else in the text is ignored. */
export function readRanges(text: string): number[] {
  const indices = new Set<number>();
  for (const range of text.split(',')) {
    const [, from, to = from] = /^([1-9]\d{0,5})(?:-([1-9]\d{0,5}))?$/.exec(range) ?? [];
    if (from === undefined) continue;
    for (let number = Number(from); number <= Number(to) && indices.size < MAX_INDICES; number++)
      indices.add(number - 1);
  }
  return [...indices].sort((a, b) => a - b);
}
