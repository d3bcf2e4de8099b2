import { type BufferGeometry, Matrix4, Vector3 } from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { LINE_FLOATS } from '../../../../src/mesh/intersections/joinSegments.js';
import type { IntersectingMesh } from '../../../../src/mesh/intersections/MeetingMesh.js';

/** A geometry as a mesh that may meet others. @param edges points at the ends of edges that have a line */
export function meetingMesh(geometry: BufferGeometry, place = new Matrix4(), edges: number[] = []): IntersectingMesh {
  const { attributes, index } = geometry.index ? geometry : mergeVertices(geometry);
  return {
    positions: Float32Array.from(attributes.position.array),
    normals: Float32Array.from(attributes.normal.array),
    triangles: Uint32Array.from(index!.array),
    edges: Uint32Array.from(edges),
    toShared: [...place.elements],
  };
}

/** A segment of a line. */
export interface Segment {
  from: Vector3;
  to: Vector3;
}

export const segmentsIn = (lines: Float64Array): Segment[] =>
  Array.from({ length: lines.length / LINE_FLOATS }, (_, i) => ({
    from: new Vector3().fromArray(lines, LINE_FLOATS * i),
    to: new Vector3().fromArray(lines, LINE_FLOATS * i + 3),
  }));

export const lengthOf = (segments: readonly Segment[]): number =>
  segments.reduce((sum, { from, to }) => sum + from.distanceTo(to), 0);

/** How many segments end at each place. */
export function endsAt(segments: readonly Segment[]): number[] {
  const counts = new Map<string, number>();
  for (const { from, to } of segments)
    for (const end of [from, to]) counts.set(end.toArray().join(), (counts.get(end.toArray().join()) ?? 0) + 1);
  return [...counts.values()];
}

/** The length along which a plane, x = at, cuts triangles between bounds of y and z: one triangle after another, clipped. */
export function slicedLength(geometry: BufferGeometry, place: Matrix4, at: number, bound: number): number {
  const { position } = geometry.attributes;
  const index = geometry.index!;
  let length = 0;
  for (let i = 0; i < index.count; i += 3) {
    const corners = [0, 1, 2].map((k) =>
      new Vector3().fromBufferAttribute(position, index.getX(i + k)).applyMatrix4(place),
    );
    const cuts: Vector3[] = [];
    for (let k = 0; k < 3; k++) {
      const [a, b] = [corners[k], corners[(k + 1) % 3]];
      if (a.x < at !== b.x < at) cuts.push(a.clone().lerp(b, (at - a.x) / (b.x - a.x)));
    }
    if (cuts.length === 2) length += clippedLength(cuts[0], cuts[1], bound);
  }
  return length;
}

/** The length of a segment within |y|, |z| ≤ bound. */
function clippedLength(a: Vector3, b: Vector3, bound: number): number {
  let [from, to] = [0, 1];
  for (const axis of ['y', 'z'] as const) {
    const slope = b[axis] - a[axis];
    const [one, other] = [(-bound - a[axis]) / slope, (bound - a[axis]) / slope];
    if (slope === 0) {
      if (Math.abs(a[axis]) > bound) return 0;
      continue;
    }
    from = Math.max(from, Math.min(one, other));
    to = Math.min(to, Math.max(one, other));
  }
  return Math.max(to - from, 0) * a.distanceTo(b);
}
