import { nextCorner } from '../../../../src/mesh/corners.js';
import { bakeForm, LINES_PER_RADIUS } from '../../../../src/mesh/form/bakeForm.js';
import { FORM_DEFAULTS, type FormField, type FormOptions } from '../../../../src/mesh/form/FormField.js';
import { formVertices } from '../../../../src/mesh/form/formVertices.js';
import { phaseLevels } from '../../../../src/mesh/form/phase/phaseLevels.js';
import { phaseMatrix } from '../../../../src/mesh/form/phase/phaseMatrix.js';
import { phaseSource } from '../../../../src/mesh/form/phase/phaseSource.js';
import { NO_OFFSET, seamRelations } from '../../../../src/mesh/form/phase/seamRelations.js';
import { solvePhase } from '../../../../src/mesh/form/phase/solvePhase.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { cross, dot, unit } from '../features/surfaces.js';
import { finish } from '../meshes.js';
import { frontOf, twinsOf } from './fronts.js';

/** The form field of a mesh, whose creases are borders. */
export function formOf(mesh: TriangleMesh, options: Partial<FormOptions> = {}): FormField {
  const { adjacency, radius, twins } = twinsOf(mesh);
  return finish(bakeForm(mesh, adjacency, twins, radius, { ...FORM_DEFAULTS, ...options }));
}

/** The form field of a whole surface with all intermediate results: φ and φ₂ of each corner in double precision. */
export function phaseOf(mesh: TriangleMesh, options: Partial<FormOptions> = {}, creases = false) {
  const front = frontOf(mesh, options, creases);
  const { surface, directions, seam } = front;
  const relations = finish(seamRelations(surface, seam));
  const { matrix, shares } = finish(phaseMatrix(surface, seam, relations));
  const levels = finish(phaseLevels(matrix));
  const families = {
    slope: LINES_PER_RADIUS / surface.radius,
    crossAngle: options.crossAngle ?? FORM_DEFAULTS.crossAngle,
  };
  const source = finish(phaseSource(surface, directions, seam, relations, shares, families));
  const phase = finish(solvePhase(surface, seam, relations, levels, source));
  const valueAt = (corner: number, family: 0 | 1): number => {
    const wedge = seam.wedges.ofCorner[corner];
    const offset = relations.ofWedge[wedge];
    const value = relations.signs[wedge] * phase.nodes[2 * surface.fans.ofCorner[corner] + family];
    return offset === NO_OFFSET ? value : value + phase.offsets[2 * offset + family];
  };
  return {
    ...front,
    relations,
    matrix,
    source,
    phase,
    valueAt,
    field: finish(formVertices(surface, seam, relations, phase)),
  };
}

export type WholePhase = ReturnType<typeof phaseOf>;

/**
 * The jumps of a family at both ends of each edge of the cut, from corner `first` to `end`: φ′ − sφ. Punctures, where φ is open, are
 * left out.
 */
export function jumpsOf(
  { surface, seam, valueAt }: WholePhase,
  family: 0 | 1,
  first = 0,
  end = surface.twins.length,
): [atStart: number, atEnd: number][] {
  const { ofCorner } = surface.fans;
  const isHole = (corner: number) => seam.isPuncture[ofCorner[corner]] === 1;
  return [...surface.twins.entries()]
    .filter(
      ([corner]) =>
        corner >= first && corner < end && seam.cut[corner] === 1 && !isHole(corner) && !isHole(nextCorner(corner)),
    )
    .map(([corner, twin]) => {
      const sign = seam.cutSign[corner];
      return [
        valueAt(nextCorner(twin), family) - sign * valueAt(corner, family),
        valueAt(twin, family) - sign * valueAt(nextCorner(corner), family),
      ];
    });
}

/** The lengths of the lines φ = whole number, followed across the cut. */
export function lineLengths(whole: WholePhase, family: 0 | 1): number[] {
  const { mesh, surface, seam, valueAt } = whole;
  const parents: number[] = [];
  const rootOf = (line: number): number => (parents[line] === line ? line : rootOf(parents[line]));
  const known = new Map<string, number>();
  /** The line of a level where it crosses an edge, as seen from the earlier half of the edge. */
  const lineAt = (corner: number, level: number): number => {
    const twin = surface.twins[corner];
    const sign = seam.cutSign[corner];
    const isLater = twin >= 0 && twin < corner;
    const seen = isLater
      ? Math.round(valueAt(nextCorner(twin), family) + sign * (level - valueAt(corner, family)))
      : level;
    const key = `${isLater ? twin : corner} ${seen}`;
    const line = known.get(key) ?? parents.push(parents.length) - 1;
    known.set(key, line);
    return line;
  };
  const point = (corner: number, share: number) => {
    const a = 3 * mesh.indices[corner];
    const b = 3 * mesh.indices[nextCorner(corner)];
    return [0, 1, 2].map((axis) => (1 - share) * mesh.positions[a + axis] + share * mesh.positions[b + axis]);
  };
  const pieces: [line: number, length: number][] = [];
  for (let first = 0; first < mesh.indices.length; first += 3) {
    // A shift too small to move a line, so that no vertex lies on one.
    const values = [0, 1, 2].map((k) => valueAt(first + k, family) + 1e-7);
    for (let level = Math.ceil(Math.min(...values)); level <= Math.max(...values); level++) {
      const crossed = [0, 1, 2].filter((k) => values[k] < level !== values[(k + 1) % 3] < level);
      const ends = crossed.map((k) => point(first + k, (level - values[k]) / (values[(k + 1) % 3] - values[k])));
      const [a, b] = crossed.map((k) => lineAt(first + k, level));
      parents[rootOf(a)] = rootOf(b);
      pieces.push([a, Math.hypot(...ends[0].map((value, axis) => value - ends[1][axis]))]);
    }
  }
  const lengths = new Map<number, number>();
  for (const [line, length] of pieces) lengths.set(rootOf(line), (lengths.get(rootOf(line)) ?? 0) + length);
  return [...lengths.values()];
}

/**
 * The angles in degrees by which lines turn at the middles of edges, for φ as the shader draws it: w + G·½P, where w = φ − ½g·P and
 * the gradient G are interpolated from the corners.
 */
export function kinksOf({ mesh: { positions, indices }, surface, field }: WholePhase): number[] {
  const pointOf = (corner: number) => [...positions.subarray(3 * indices[corner], 3 * indices[corner] + 3)];
  const gradientOf = (corner: number) => {
    const i = 3 * field.ofCorner[corner];
    return [...field.slopes.subarray(i, i + 3)];
  };
  /** The direction of φ's rise at a point of a triangle, as an angle from the edge that starts at `corner`. */
  const angleAt = (corner: number, point: number[], along: number[]): number => {
    const first = corner - (corner % 3);
    const area = [...surface.areaNormals.subarray(first, first + 3)];
    const normal = area.map((value) => value / Math.hypot(...area));
    const rise = [0, 0, 0];
    for (let k = 0; k < 3; k++) {
      const [a, b, c] = [0, 1, 2].map((step) => pointOf(first + ((k + step) % 3)));
      const g = gradientOf(first + k);
      const value = field.values[2 * field.ofCorner[first + k]] - 0.5 * dot(g, a);
      const slope = cross(
        normal,
        c.map((coordinate, axis) => (coordinate - b[axis]) / Math.hypot(...area)),
      );
      const share = dot(slope, minus(point, b));
      for (let axis = 0; axis < 3; axis++) {
        rise[axis] += slope[axis] * (value + 0.5 * dot(g, point)) + 0.5 * share * g[axis];
      }
    }
    return Math.atan2(dot(rise, cross(normal, along)), dot(rise, along));
  };
  return [...surface.twins.entries()]
    .filter(([corner, twin]) => twin > corner)
    .map(([corner, twin]) => {
      const [a, b] = [pointOf(corner), pointOf(nextCorner(corner))];
      const middle = a.map((value, axis) => (value + b[axis]) / 2);
      const along = unit(minus(b, a));
      const turns = (angleAt(corner, middle, along) - angleAt(twin, middle, along)) / Math.PI;
      return 180 * Math.abs(turns - Math.round(turns));
    });
}

const minus = (a: readonly number[], b: readonly number[]): number[] => a.map((value, i) => value - b[i]);
