import { bakeCorners } from '../../mesh/bake/bakeCorners.js';
import { bakeJointForms } from '../../mesh/bake/bakeJointForms.js';
import { bakePull } from '../../mesh/bake/bakePull.js';
import { task } from './task.js';

/** The tasks that bake geometries with adjacency, and the forms that several share. */
export const geometryTasks = {
  bakeCorners: /* @__PURE__ */ task(bakeCorners),
  bakeJointForms: /* @__PURE__ */ task(bakeJointForms),
  bakePull: /* @__PURE__ */ task(bakePull),
};
