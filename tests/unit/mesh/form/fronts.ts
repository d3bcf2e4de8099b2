import { buildTriangleAdjacency, consistentTwins } from '../../../../src/mesh/adjacency/buildTriangleAdjacency.js';
import { nearnessOf } from '../../../../src/mesh/bake/bakeSurface.js';
import { NO_TWIN, nextCorner, previousCorner, triangleOf } from '../../../../src/mesh/corners.js';
import { disjointSets, join, rootOf } from '../../../../src/mesh/disjointSets.js';
import { cutForm, type FormSeam } from '../../../../src/mesh/form/cutForm.js';
import { directionField } from '../../../../src/mesh/form/directions/directionField.js';
import { faceDirections } from '../../../../src/mesh/form/directions/faceDirections.js';
import { FORM_DEFAULTS, type FormOptions } from '../../../../src/mesh/form/FormField.js';
import {
  type FormSurface,
  findParts,
  formSurface,
  formTwins,
  surfaceWithin,
} from '../../../../src/mesh/form/FormSurface.js';
import { measureBounds } from '../../../../src/mesh/measureBounds.js';
import { cutSharpEdges } from '../../../../src/mesh/normals/cutCreases.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { cross, dot } from '../features/surfaces.js';
import { finish } from '../meshes.js';

/** The twins of a mesh: all, those without sharp edges, and those without the creases that are borders of the field. */
export function twinsOf(mesh: TriangleMesh) {
  const bounds = finish(measureBounds(mesh));
  const adjacency = finish(buildTriangleAdjacency(mesh, nearnessOf(bounds)));
  const whole = finish(consistentTwins(adjacency));
  const sharp = whole.slice();
  finish(cutSharpEdges(sharp, adjacency.areaNormals));
  const parts = finish(findParts(mesh, whole, adjacency.areaNormals, bounds.radius));
  const twins = finish(formTwins(whole, adjacency.areaNormals, bounds.radius, parts));
  return { adjacency, radius: bounds.radius, parts, whole, sharp, twins };
}

/** The surface of a form field. Without `creases` it is whole. */
export function surfaceOf(mesh: TriangleMesh, options: FormOptions = FORM_DEFAULTS, creases = true): FormSurface {
  const { adjacency, radius, parts, whole } = twinsOf(mesh);
  return finish(
    creases
      ? formSurface(mesh, adjacency, whole, radius, options)
      : surfaceWithin(mesh, adjacency, whole, radius, parts, options),
  );
}

/** The stages of a form field before its phase. Without `creases` the surface is whole. */
export function frontOf(mesh: TriangleMesh, options: Partial<FormOptions> = {}, creases = true) {
  const all = { ...FORM_DEFAULTS, ...options };
  const surface = surfaceOf(mesh, all, creases);
  const field = finish(directionField(surface, all));
  const directions = finish(faceDirections(surface, field));
  return { mesh, surface, field, directions, seam: finish(cutForm(surface, directions)) };
}

/** A connected piece of a surface. */
interface Piece {
  faces: number;
  /** Vertices − edges + faces. */
  euler: number;
  /** The sum of the indices of its singular points. */
  index: number;
  isClosed: boolean;
}

/** The pieces of a surface, with both sides of the Poincaré-Hopf theorem. */
export function piecesOf({ twins, fans }: FormSurface, { halfTurns }: FormSeam): Piece[] {
  const parents = disjointSets(twins.length / 3);
  for (const [corner, twin] of twins.entries()) if (twin > corner) join(parents, triangleOf(corner), triangleOf(twin));
  const pieces = new Map<number, Piece>();
  const seen = new Set<number>();
  for (const [corner, twin] of twins.entries()) {
    const root = rootOf(parents, triangleOf(corner));
    const piece = pieces.get(root) ?? { faces: 0, euler: 0, index: 0, isClosed: true };
    pieces.set(root, piece);
    if (corner % 3 === 0) {
      piece.faces++;
      piece.euler++;
    }
    if (twin < corner) piece.euler--;
    if (twin < 0) piece.isClosed = false;
    const fan = fans.ofCorner[corner];
    if (seen.has(fan)) continue;
    seen.add(fan);
    piece.euler++;
    piece.index += halfTurns[fan] / 2;
  }
  return [...pieces.values()];
}

/**
 * How often the border of a whole surface turns, as one walks along it with the surface on the left, against the field of directions:
 * once around a disc that is ruled one way, and not at all around one of rings.
 */
export function borderTurns({ mesh: { positions, indices }, surface, directions }: ReturnType<typeof frontOf>): number {
  const { twins } = surface;
  /** The angle from the direction of a corner's face to the edge from it to another corner, about the normal of the face. */
  const angleTo = (corner: number, other: number): number => {
    const face = 3 * triangleOf(corner);
    const u = [...directions.across.subarray(face, face + 3)];
    const n = [...directions.normals.subarray(face, face + 3)];
    const edge = [0, 1, 2].map((axis) => positions[3 * indices[other] + axis] - positions[3 * indices[corner] + axis]);
    return Math.atan2(dot(cross(n, u), edge), dot(u, edge));
  };
  let angle = 0;
  for (const [border, twin] of twins.entries()) {
    if (twin !== NO_TWIN) continue;
    // From the border that ends here, across the faces of the fan, to the border that starts here.
    angle += Math.PI;
    for (let corner = nextCorner(border); ; ) {
      const within = angleTo(corner, previousCorner(corner)) - angleTo(corner, nextCorner(corner));
      angle -= within - 2 * Math.PI * Math.floor(within / (2 * Math.PI));
      const across = twins[corner];
      if (across === NO_TWIN) break;
      const next = nextCorner(across);
      const turn = angleTo(next, across) - angleTo(corner, nextCorner(corner));
      angle += turn - Math.PI * Math.round(turn / Math.PI);
      corner = next;
    }
  }
  return angle / (2 * Math.PI);
}

/** The position of each singular point. */
export function singularPoints({ mesh, surface, seam }: ReturnType<typeof frontOf>): number[][] {
  const points = new Map<number, number[]>();
  for (const [corner, fan] of surface.fans.ofCorner.entries()) {
    if (seam.halfTurns[fan] === 0) continue;
    const i = 3 * mesh.indices[corner];
    points.set(fan, [...mesh.positions.subarray(i, i + 3)]);
  }
  return [...points.values()];
}

/** For each face its middle and its direction. */
export function facesOf({ mesh: { positions, indices }, directions: { across } }: ReturnType<typeof frontOf>) {
  return Array.from({ length: indices.length / 3 }, (_, face) => {
    const corners = [...indices.subarray(3 * face, 3 * face + 3)].map((i) => positions.subarray(3 * i, 3 * i + 3));
    return {
      middle: [0, 1, 2].map((axis) => (corners[0][axis] + corners[1][axis] + corners[2][axis]) / 3),
      across: [...across.subarray(3 * face, 3 * face + 3)],
    };
  });
}
