import { bakeCorners } from '../../mesh/bake/bakeCorners.js';
import { bakeIndexed } from '../../mesh/bake/bakeIndexed.js';
import { bakeJointForms } from '../../mesh/bake/bakeJointForms.js';
import { bakePull } from '../../mesh/bake/bakePull.js';
import { searchContours } from '../../mesh/features/contourCandidates.js';
import { task } from './task.js';

/** The tasks that bake geometries. */
export const geometryTasks = {
  bakeCorners: /* @__PURE__ */ task(bakeCorners),
  bakeIndexed: /* @__PURE__ */ task(bakeIndexed),
  bakeJointForms: /* @__PURE__ */ task(bakeJointForms),
  bakePull: /* @__PURE__ */ task(bakePull),
  searchContours: /* @__PURE__ */ task(searchContours),
};
