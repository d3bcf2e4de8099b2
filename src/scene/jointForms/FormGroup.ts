import type { HatchingFormOptions } from '../../material/geometry/HatchingFormOptions.js';
import type { GeometryPart } from '../../material/geometry/jointForms.js';
import type { PrepareHatchingGeometryOptions } from '../../material/geometry/PrepareHatchingGeometryOptions.js';

/** Geometries that may touch, so that lines along their form are to run on from one to the next. */
export interface FormGroup {
  /** In the object space of the first. */
  parts: readonly GeometryPart[];
  /** What the first asks for. */
  form: HatchingFormOptions;
}

/** What one geometry is baked for. */
export interface GeometryPlan extends Pick<PrepareHatchingGeometryOptions, 'layout' | 'form'> {
  /** Those with which it shares a form, if they touch it. */
  group?: FormGroup | undefined;
}
