import type { BufferGeometry } from 'three';
import type { HatchingFormOptions } from '../../material/geometry/HatchingFormOptions.js';
import { bakeJointForms } from '../../material/geometry/jointForms.js';
import type { PrepareHatchingGeometryOptions } from '../../material/geometry/PrepareHatchingGeometryOptions.js';
import type { JointForm } from '../../mesh/bake/bakeJointForms.js';
import { cornerCount, type FormGroup, type GeometryPlan } from './FormGroup.js';

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
export const groupCorners = ({ parts }: FormGroup): number =>
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
