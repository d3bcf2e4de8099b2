import { buildTriangleAdjacency, type TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { consistentTwins } from '../adjacency/consistentTwins.js';
import { triangleOf } from '../corners.js';
import { disjointSets, join, rootOf } from '../disjointSets.js';
import { bakeChosenForm, bakeForm } from '../form/bakeForm.js';
import type { FormField } from '../form/FormField.js';
import { measureBounds } from '../measureBounds.js';
import { cutCreases } from '../normals/cutCreases.js';
import { asPhase } from '../phases.js';
import { validateTriangleMesh } from '../TriangleMesh.js';
import { type FormRequest, nearnessOf } from './bakeSurface.js';
import { fieldOfPart, type JoinedParts, joinParts, type Part, partOfTriangles } from './joinParts.js';

/** The input of `bakeJointForms`. Plain data: it is posted to the worker. */
export interface JointFormsRequest {
  parts: readonly Part[];
  /** As in `SurfaceRequest`. */
  creaseAngle: number;
  weldTolerance?: number | undefined;
  /** Axes are in the space that all parts share. */
  form: FormRequest;
}

/** The form of a part: its share of a field, `'light'` if the parts together have no form, or `'alone'` if the part meets no other. */
export type JointForm = FormField | 'light' | 'alone';

/** Vertices of different parts are transformed by different matrices, which costs some digits. */
const LEAST_TOLERANCE = 1e-5;

/**
 * Bakes form fields of parts whose borders meet as if they were one mesh, so that lines continue from part to part. Parts that meet no
 * other are skipped. Throws a RangeError for an invalid mesh.
 */
export function* bakeJointForms(request: JointFormsRequest): Generator<number, JointForm[], void> {
  const { parts } = request;
  const forms: JointForm[] = parts.map(() => 'alone');
  const all = yield* asPhase(jointSurface(parts, request), 0, 0.1);
  const groups = touching(all);
  const corners = groups.flat().reduce((sum, part) => sum + parts[part].mesh.indices.length, 0);
  let done = 0;
  for (const group of groups) {
    const begun = done / corners;
    const members = group.map((part) => parts[part]);
    for (const { mesh } of members) done += mesh.indices.length;
    const fields = yield* asPhase(
      groupForms(members, members.length === parts.length ? all : null, request),
      0.1 + 0.9 * begun,
      0.1 + (0.9 * done) / corners,
    );
    for (const [i, part] of group.entries()) forms[part] = fields[i];
  }
  return forms;
}

/** All parts as one surface. */
interface JointSurface {
  joined: JoinedParts;
  radius: number;
  adjacency: TriangleAdjacency;
  /** With NO_TWIN at creases and where windings contradict each other. */
  twins: Int32Array<ArrayBuffer>;
}

function* jointSurface(
  parts: readonly Part[],
  { creaseAngle, weldTolerance }: JointFormsRequest,
): Generator<number, JointSurface, void> {
  const joined = yield* asPhase(joinParts(parts), 0, 0.1);
  yield* asPhase(validateTriangleMesh(joined.mesh, 'bakeJointForms: the mesh'), 0.1, 0.2);
  const bounds = yield* asPhase(measureBounds(joined.mesh), 0.2, 0.3);
  const nearness = nearnessOf(bounds, Math.max(weldTolerance ?? 0, LEAST_TOLERANCE));
  const adjacency = yield* asPhase(buildTriangleAdjacency(joined.mesh, nearness), 0.3, 0.9);
  yield* asPhase(cutCreases(adjacency, creaseAngle), 0.9, 0.95);
  const twins = yield* asPhase(consistentTwins(adjacency), 0.95, 1);
  return { joined, radius: bounds.radius, adjacency, twins };
}

/** The groups of two or more parts that have neighbours across borders. */
function touching({ joined, twins }: JointSurface): number[][] {
  const partOf = partOfTriangles(joined);
  const count = joined.firstCorners.length - 1;
  const sets = disjointSets(count);
  for (let corner = 0; corner < twins.length; corner++) {
    if (twins[corner] < corner) continue;
    const a = partOf[triangleOf(corner)];
    const b = partOf[triangleOf(twins[corner])];
    if (a !== b) join(sets, a, b);
  }
  const groups = new Map<number, number[]>();
  for (let part = 0; part < count; part++) {
    const root = rootOf(sets, part);
    groups.set(root, [...(groups.get(root) ?? []), part]);
  }
  return [...groups.values()].filter(({ length }) => length > 1);
}

/** The forms of parts that are all joined to each other. */
function* groupForms(
  parts: readonly Part[],
  known: JointSurface | null,
  request: JointFormsRequest,
): Generator<number, JointForm[], void> {
  const { joined, radius, adjacency, twins } = known ?? (yield* asPhase(jointSurface(parts, request), 0, 0.1));
  const bakeField = request.form.isChosen ? bakeChosenForm : bakeForm;
  const whole = yield* asPhase(bakeField(joined.mesh, adjacency, twins, radius, request.form), 0.1, 0.95);
  const forms: JointForm[] = [];
  for (const [i, part] of parts.entries()) {
    forms.push(whole ? yield* asPhase(fieldOfPart(joined, i, part, whole), 0.95, 1) : 'light');
  }
  return forms;
}

/** The buffers of forms, which are transferred with them. */
export const jointFormsBuffers = (forms: readonly JointForm[]): ArrayBuffer[] =>
  forms.flatMap((form) =>
    typeof form === 'string'
      ? []
      : [form.ofCorner.buffer, form.values.buffer, form.slopes.buffer, form.crossings.buffer],
  );
