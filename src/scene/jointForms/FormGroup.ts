import type { BufferGeometry } from 'three';
import type { HatchingFormOptions } from '../../material/geometry/HatchingFormOptions.js';
import type { GeometryPart } from '../../material/geometry/jointForms.js';
import type { PrepareHatchingGeometryOptions } from '../../material/geometry/PrepareHatchingGeometryOptions.js';

/** Geometries that may touch, so that lines along their form continue from one to the next. */
export interface FormGroup {
  /** The parts, with matrices to the object space of the first. */
  parts: readonly GeometryPart[];
  /** The form options of the first. */
  form: HatchingFormOptions;
}

/** The options that one geometry is baked with. */
export interface GeometryPlan extends Pick<PrepareHatchingGeometryOptions, 'layout' | 'form'> {
  /** The geometries that share a form with it, if they touch it. */
  group?: FormGroup | undefined;
}

/** The number of corners of a geometry, whatever its draw range. */
export const cornerCount = ({ index, attributes }: BufferGeometry): number =>
  (index ?? attributes.position)?.count ?? 0;
