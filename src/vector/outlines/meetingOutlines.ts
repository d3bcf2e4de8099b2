import { dot, type Vec3, vectorAt } from '../../look/vectors.js';
import { SEGMENT_POINTS } from '../../mesh/bake/outlineLayout.js';
import { findIntersections } from '../../mesh/intersections/findIntersections.js';
import { LINE_FLOATS } from '../../mesh/intersections/joinSegments.js';
import type { IntersectingMesh } from '../../mesh/intersections/MeetingMesh.js';
import type { OutlinedMesh } from '../DrawnScene.js';
import type { FeatureEdge, OutlineLook, OutlineMesh } from './OutlineMesh.js';

/** Numbers of a segment at which the position and the normal of each point begin. */
const PLACES = [0, 3, 0, 3];
const NORMALS = [6, 9, 12, 15];

/**
 * The lines along which outlined meshes cut each other, where their outlines ask for them, as edges of meshes without triangles. Those of a
 * pair lie on the surface that is less opaque, which hides nothing of itself, and look like outlines of the other. Yields its progress.
 */
export function* meetingOutlines(outlines: readonly OutlinedMesh[]): Generator<number, OutlinedMesh[], void> {
  const asked = outlines.filter(({ look }) => look.intersections > 0 && !look.isCutOut);
  if (asked.length === 0) return [];
  const found = yield* findIntersections({ meshes: asked.map(({ mesh }) => intersecting(mesh)) });
  const lines = new Map<OutlinedMesh, Map<OutlineLook, Float64Array[]>>();
  for (const { first, second, lines: ofPair } of found) {
    if (!ofPair) continue;
    const isSecondClear = asked[second].look.opacity < asked[first].look.opacity;
    const [holder, { look }] = isSecondClear ? [asked[second], asked[first]] : [asked[first], asked[second]];
    const ofHolder = lines.get(holder) ?? new Map<OutlineLook, Float64Array[]>();
    lines.set(holder, ofHolder);
    ofHolder.set(look, [...(ofHolder.get(look) ?? []), ofPair]);
  }
  return [...lines].flatMap(([holder, looks]) =>
    [...looks].map(([look, parts]) => ({ ...holder, look, mesh: meetingMesh(holder.mesh, parts) })),
  );
}

function intersecting({ positions, normals, triangles, edges, toWorld }: OutlineMesh): IntersectingMesh {
  const lined = edges.filter(({ isBorder, isCrease, isMaterialBorder }) => isBorder || isCrease || isMaterialBorder);
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    triangles: Uint32Array.from(triangles),
    edges: Uint32Array.from(lined.flatMap(({ leftStart, leftEnd }) => [leftStart, leftEnd])),
    toShared: Array.from(toWorld),
  };
}

/** A mesh whose only edges are lines of intersection, in world space. */
function meetingMesh(mesh: OutlineMesh, lines: readonly Float64Array[]): OutlineMesh {
  const count = lines.reduce((sum, { length }) => sum + length, 0) / LINE_FLOATS;
  const positions = new Float64Array(3 * SEGMENT_POINTS * count);
  const normals = new Float64Array(3 * SEGMENT_POINTS * count);
  const placeOf = new Uint32Array(SEGMENT_POINTS * count);
  const edges: FeatureEdge[] = [];
  const places = new Map<string, number>();
  for (const ofPair of lines) {
    for (let o = 0; o < ofPair.length; o += LINE_FLOATS) {
      const first = SEGMENT_POINTS * edges.length;
      for (let k = 0; k < SEGMENT_POINTS; k++) {
        const place = vectorAt(ofPair, o + PLACES[k]);
        const key = place.join();
        placeOf[first + k] = places.get(key) ?? first + k;
        places.set(key, placeOf[first + k]);
        positions.set(inObject(mesh, place), 3 * (first + k));
        normals.set(normalInObject(mesh, vectorAt(ofPair, o + NORMALS[k])), 3 * (first + k));
      }
      edges.push({
        ...{ leftStart: first, leftEnd: first + 1, rightStart: first + 2, rightEnd: first + 3 },
        ...{ isBorder: false, isCrease: false, isMaterialBorder: false, isIntersection: true, isContrary: false },
        ...{ isCornerAtStart: false, isCornerAtEnd: false, spacing: Infinity },
      });
    }
  }
  return {
    ...mesh,
    ...{ positions, normals, placeOf, edges },
    anchors: Float32Array.from(positions),
    curvatures: new Float32Array(6 * SEGMENT_POINTS * count),
    triangles: new Uint32Array(0),
    spacings: new Float32Array(0),
  };
}

/** A place in the world, in the space of a mesh. The inverse of a matrix is the transpose of that of normals. */
function inObject({ toWorld: m, normalToWorld: rows }: OutlineMesh, place: Vec3): Vec3 {
  const away = [place[0] - m[12], place[1] - m[13], place[2] - m[14]];
  const along = (axis: number): number => rows[0][axis] * away[0] + rows[1][axis] * away[1] + rows[2][axis] * away[2];
  return [along(0), along(1), along(2)];
}

/** A normal in the world, in the space of a mesh. */
function normalInObject({ toWorld: m }: OutlineMesh, normal: Vec3): Vec3 {
  const column = (k: number): Vec3 => [m[4 * k], m[4 * k + 1], m[4 * k + 2]];
  const turned = [dot(column(0), normal), dot(column(1), normal), dot(column(2), normal)] as const;
  const length = Math.hypot(...turned) || 1;
  return [turned[0] / length, turned[1] / length, turned[2] / length];
}
