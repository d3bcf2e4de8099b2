import { Box3, type BufferAttribute, type BufferGeometry, Matrix4, type Mesh, type SkinnedMesh } from 'three';
import { checkGeometry } from '../material/geometry/checkGeometry.js';
import type { HatchingFormOptions } from '../material/geometry/HatchingFormOptions.js';
import { bakeJointForms } from '../material/geometry/jointForms.js';
import type { PrepareHatchingGeometryOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { JointForm } from '../mesh/bake/bakeJointForms.js';
import { cornerCount, type FormGroup, type GeometryPlan } from './geometryPlans.js';

/** The bake of a group, for those of its geometries whose lines cross at one angle. */
interface GroupBake {
  group: FormGroup;
  /** The form options of the group's first geometry, with this angle. */
  form: HatchingFormOptions;
  geometries: Set<BufferGeometry>;
}

/** The bakes for a set of geometries: one per group, and one more per angle that was changed for some of its members. */
function bakesFor(plans: ReadonlyMap<BufferGeometry, GeometryPlan>): GroupBake[] {
  const bakes = new Map<FormGroup, Map<number | undefined, GroupBake>>();
  for (const [geometry, { group, form }] of plans) {
    if (!group || typeof form !== 'object') continue;
    const { crossAngle } = form;
    const ofGroup = bakes.get(group) ?? new Map<number | undefined, GroupBake>();
    bakes.set(group, ofGroup);
    const bake = ofGroup.get(crossAngle) ?? { group, form: { ...group.form, crossAngle }, geometries: new Set() };
    ofGroup.set(crossAngle, bake);
    bake.geometries.add(geometry);
  }
  return [...bakes.values()].flatMap((ofGroup) => [...ofGroup.values()]);
}

/** The number of corners of a group. */
const groupCorners = ({ parts }: FormGroup): number =>
  parts.reduce((sum, { geometry }) => sum + cornerCount(geometry), 0);

/**
 * Bakes the forms that geometries share, one group after the other. A group with a faulty geometry is skipped: the separate bakes of
 * its members name the fault.
 *
 * @returns the forms of the geometries that touch others
 */
export async function bakeGroups(
  plans: ReadonlyMap<BufferGeometry, GeometryPlan>,
  { onProgress, ...options }: PrepareHatchingGeometryOptions,
): Promise<Map<BufferGeometry, JointForm>> {
  const bakes = bakesFor(plans);
  const total = bakes.reduce((sum, { group }) => sum + groupCorners(group), 0);
  const forms = new Map<BufferGeometry, JointForm>();
  let done = 0;
  for (const { group, form, geometries } of bakes) {
    const corners = groupCorners(group);
    const report = onProgress && ((progress: number): void => onProgress((done + progress * corners) / total));
    try {
      const baked = await bakeJointForms(group.parts, { ...options, form, onProgress: report });
      for (const [i, { geometry }] of group.parts.entries())
        if (geometries.has(geometry)) forms.set(geometry, baked[i]);
    } catch (error) {
      if (!(error instanceof TypeError || error instanceof RangeError)) throw error;
    }
    options.signal?.throwIfAborted();
    done += corners;
  }
  onProgress?.(1);
  return forms;
}

/** The number of corners above which a group is not baked jointly. */
const MAX_CORNERS = 6_000_000;

/** The greatest gap between touching boxes, as a share of the larger one's diagonal. */
const NEAR = 1e-5;

/** A mesh that alone uses its geometry. */
interface Candidate {
  geometry: BufferGeometry;
  /** The matrix to the space in which meshes are compared: the world, or that of the bones at rest. */
  matrix: Matrix4;
  form: HatchingFormOptions;
}

/**
 * Groups the geometries to bake by whether their bounding boxes touch at rest. Meshes are compared in world space, skinned ones in bind
 * space. Geometries of several meshes, instances and batches are in no group. It yields after each mesh.
 *
 * @returns the group of each geometry that is in one
 */
export function* formGroups(
  planned: readonly { mesh: Mesh; geometry: BufferGeometry }[],
  plans: ReadonlyMap<BufferGeometry, GeometryPlan>,
): Generator<number, ReadonlyMap<BufferGeometry, FormGroup>, void> {
  const uses = new Map<BufferGeometry, number>();
  for (const { geometry } of planned) uses.set(geometry, (uses.get(geometry) ?? 0) + 1);
  const spaces = new Map<object, Map<string, Candidate[]>>();
  for (const [i, { mesh, geometry }] of planned.entries()) {
    yield i / planned.length;
    const form = plans.get(geometry)?.form;
    if (typeof form !== 'object' || uses.get(geometry) !== 1 || 'isBatchedMesh' in mesh || 'isInstancedMesh' in mesh)
      continue;
    if (!isReadable(geometry)) continue;
    const { space, matrix } = restOf(mesh);
    if (cornerCount(geometry) > MAX_CORNERS || !(Math.abs(matrix.determinant()) > 0)) continue;
    const kind = JSON.stringify({ ...form, up: null, front: null });
    const kinds = spaces.get(space) ?? new Map<string, Candidate[]>();
    spaces.set(space, kinds);
    const alike = kinds.get(kind) ?? [];
    kinds.set(kind, alike);
    alike.push({ geometry, matrix, form });
  }
  const groups = new Map<BufferGeometry, FormGroup>();
  for (const kinds of spaces.values()) {
    for (const candidates of kinds.values()) {
      for (const members of yield* touching(candidates)) {
        const group = groupOf(members);
        if (members.length === 1 || groupCorners(group) > MAX_CORNERS) continue;
        for (const { geometry } of members) groups.set(geometry, group);
      }
    }
  }
  return groups;
}

/** Whether the positions of a geometry can be read. If not, the bake names the fault. */
function isReadable(geometry: BufferGeometry): boolean {
  try {
    checkGeometry(geometry);
    return true;
  } catch {
    return false;
  }
}

/** The key of the space of all meshes without a skin. */
const WORLD = {};

/** The space in which a mesh is compared with others, and its matrix to that space, at rest. */
function restOf(mesh: Mesh): { space: object; matrix: Matrix4 } {
  const { skeleton, bindMatrix } = mesh as SkinnedMesh;
  const [bone] = skeleton?.bones ?? [];
  return bone ? { space: bone, matrix: bindMatrix } : { space: WORLD, matrix: mesh.matrixWorld };
}

/** The pairs of candidates whose boxes touch. It yields after each box. */
function* touching(candidates: readonly Candidate[]): Generator<number, Candidate[][], void> {
  const groups = candidates.map((_, i) => [i]);
  const order: { i: number; box: Box3 }[] = [];
  // Bounding boxes take time, and a single mesh touches none.
  for (const [i, candidate] of (candidates.length > 1 ? candidates : []).entries()) {
    const box = grownBox(candidate);
    // An empty box, or one that is not finite, belongs to a geometry that cannot be baked.
    if (Number.isFinite(box.min.distanceTo(box.max))) order.push({ i, box });
    yield i / candidates.length;
  }
  order.sort((a, b) => a.box.min.x - b.box.min.x);
  for (const [place, { i, box }] of order.entries()) {
    for (let next = place + 1; next < order.length && order[next].box.min.x <= box.max.x; next++) {
      const other = groups[order[next].i];
      if (groups[i] === other || !box.intersectsBox(order[next].box)) continue;
      const [small, large] = groups[i].length < other.length ? [groups[i], other] : [other, groups[i]];
      for (const member of small) groups[member] = large;
      large.push(...small);
    }
    yield place / order.length;
  }
  return [...new Set(groups)].map((group) => group.sort((a, b) => a - b).map((i) => candidates[i]));
}

function grownBox({ geometry, matrix }: Candidate): Box3 {
  const box = new Box3().setFromBufferAttribute(geometry.attributes.position as BufferAttribute).applyMatrix4(matrix);
  return box.expandByScalar(NEAR * box.min.distanceTo(box.max));
}

function groupOf(members: readonly Candidate[]): FormGroup {
  const [{ matrix: first, form }] = members;
  const toFirst = first.clone().invert();
  const parts = members.map(({ geometry, matrix }) => ({ geometry, matrix: toFirst.clone().multiply(matrix) }));
  parts[0].matrix = new Matrix4();
  return { parts, form };
}

/** The code, beside `LaterForms`, that is fetched if lines follow the form. */
