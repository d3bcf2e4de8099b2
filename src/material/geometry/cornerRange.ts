import type { BufferGeometry } from 'three';

/** A group of a prepared geometry. `start` and `count` are in corners. */
export interface CornerGroup {
  start: number;
  count: number;
  materialIndex: number | undefined;
}

/** The drawn part of a geometry, and its groups relative to that part. All counts are multiples of three. */
export interface CornerRange {
  /** The first entry of the index, or the first vertex if there is no index. */
  start: number;
  count: number;
  groups: CornerGroup[];
}

/**
 * The draw range and the groups of a geometry, in corners, as three.js would draw them.
 *
 * @throws RangeError if a range starts or ends inside a triangle
 */
export function cornerRange(geometry: BufferGeometry, label: string): CornerRange {
  const unit = geometry.index ? 'index' : 'vertex';
  const available = geometry.index ? geometry.index.count : geometry.attributes.position.count;
  const start = Math.max(0, geometry.drawRange.start);
  const end = Math.min(available, geometry.drawRange.start + geometry.drawRange.count);
  const count = Math.max(0, end - start);
  if (count % 3 !== 0) {
    throw new RangeError(
      `${label}: the ${unit} count is ${count}, which is not a multiple of three. Remove the incomplete last triangle, or convert strips, fans and outlines to triangles first.`,
    );
  }
  const groups: CornerGroup[] = [];
  for (const [i, group] of geometry.groups.entries()) {
    const groupStart = Math.max(start, group.start) - start;
    const groupEnd = Math.min(end, group.start + group.count) - start;
    if (groupEnd <= groupStart) continue;
    if (groupStart % 3 !== 0) {
      throw new RangeError(
        `${label}: group ${i} starts at ${unit} ${group.start}, inside a triangle. Start groups and draw range at multiples of three.`,
      );
    }
    const groupCount = groupEnd - groupStart;
    groups.push({ start: groupStart, count: groupCount - (groupCount % 3), materialIndex: group.materialIndex });
  }
  return { start, count, groups };
}
