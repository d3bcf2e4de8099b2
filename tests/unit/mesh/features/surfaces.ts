import type { BufferGeometry } from 'three';
import { buildTriangleAdjacency, consistentTwins } from '../../../../src/mesh/adjacency/buildTriangleAdjacency.js';
import { bakeSurface, type SurfaceRequest } from '../../../../src/mesh/bake/bakeSurface.js';
import type { FeatureSurface } from '../../../../src/mesh/features/findFeatureEdges.js';
import { cutSharpEdges } from '../../../../src/mesh/normals/cutCreases.js';
import { computeSmoothNormals } from '../../../../src/mesh/normals/fanNormals.js';
import { buildFans, type Fans } from '../../../../src/mesh/normals/fans.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { finish, meshOf } from '../meshes.js';

export type Row = readonly number[];

/** The triangles of a geometry of three.js. */
export function meshFrom({ attributes, index }: BufferGeometry): TriangleMesh {
  const positions = Float32Array.from(attributes.position.array);
  return {
    positions,
    indices: index ? Uint32Array.from(index.array) : Uint32Array.from(positions.keys()).slice(0, positions.length / 3),
  };
}

/** A mesh with its adjacency, cut at sharp edges, and its fans: the input of `bakeOutlines`. */
export function surfaceOf(mesh: TriangleMesh) {
  const adjacency = finish(buildTriangleAdjacency(mesh));
  const sharpTwins = finish(consistentTwins(adjacency));
  finish(cutSharpEdges(sharpTwins, adjacency.areaNormals));
  const fans = finish(buildFans(sharpTwins));
  return { mesh, ...adjacency, sharpTwins, fans };
}

/** The input of `findFeatureEdges`. */
export function featureSurface(mesh: TriangleMesh, triangleGroups: Uint16Array | null = null): FeatureSurface {
  const { canonicalCorners, areaNormals, twins, sharpTwins, fans } = surfaceOf(mesh);
  const normals = finish(computeSmoothNormals(areaNormals, fans));
  return {
    mesh,
    canonicalCorners,
    areaNormals,
    joinedTwins: twins,
    sharpTwins,
    ofCorner: fans.ofCorner,
    normals,
    triangleGroups,
  };
}

/** The outlines of a mesh from the whole bake. */
export const outlinesOf = (mesh: TriangleMesh, options: Partial<SurfaceRequest> = {}) =>
  finish(
    bakeSurface(
      {
        label: 'test',
        mesh,
        creaseAngle: Math.PI / 2,
        wantsNormals: false,
        outlines: { triangleGroups: null },
        ...options,
      },
      false,
    ),
  ).outlines!;

/** The position of each fan. */
export function fanPositions({ positions, indices }: TriangleMesh, ofCorner: Uint32Array): number[][] {
  const rows: number[][] = [];
  for (const [corner, fan] of ofCorner.entries()) {
    const i = 3 * indices[corner];
    // + 0 turns −0 into 0
    rows[fan] = [...positions.subarray(i, i + 3)].map((value) => value + 0);
  }
  return rows;
}

/** A vector per fan that depends on its position. */
export const perFan = (mesh: TriangleMesh, { ofCorner }: Fans, direction: (position: Row) => Row): Float32Array =>
  new Float32Array(fanPositions(mesh, ofCorner).flatMap((position) => direction(position)));

export const scaled = ({ positions, indices }: TriangleMesh, factor: number): TriangleMesh => ({
  positions: positions.map((value) => factor * value),
  indices,
});

export const dot = (a: Row, b: Row): number => a.reduce((sum, value, i) => sum + value * b[i], 0);

export const unit = (a: Row): number[] => a.map((value) => value / Math.hypot(...a));

export const cross = (a: Row, b: Row): number[] =>
  [0, 1, 2].map((i) => a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);

/** The mesh turned by a quaternion that need not be of unit length. */
export function turned({ positions, indices }: TriangleMesh, [x, y, z, w]: Row): TriangleMesh {
  const axis = [x, y, z].map((value) => value / Math.hypot(x, y, z, w));
  const real = w / Math.hypot(x, y, z, w);
  const rotated = positions.slice();
  for (let i = 0; i < positions.length; i += 3) {
    const p = [...positions.subarray(i, i + 3)];
    const c = cross(axis, p);
    const d = cross(axis, c);
    rotated.set(
      p.map((value, k) => value + 2 * (real * c[k] + d[k])),
      i,
    );
  }
  return { positions: rotated, indices };
}

/** A Möbius strip of `around` × `across` squares, without a double vertex. */
export function moebius(around: number, across: number): TriangleMesh {
  const vertices: Row[] = [];
  for (let i = 0; i < around; i++) {
    for (let j = 0; j <= across; j++) {
      const angle = (2 * Math.PI * i) / around;
      const width = 0.4 * ((2 * j) / across - 1);
      const radius = 1 + width * Math.cos(angle / 2);
      vertices.push([radius * Math.cos(angle), radius * Math.sin(angle), width * Math.sin(angle / 2)]);
    }
  }
  const vertex = (i: number, j: number) => (i < around ? i * (across + 1) + j : across - j);
  const triangles: Row[] = [];
  for (let i = 0; i < around; i++) {
    for (let j = 0; j < across; j++) {
      const [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)] as const;
      triangles.push([a, b, c], [a, c, d]);
    }
  }
  return meshOf(vertices, triangles);
}
