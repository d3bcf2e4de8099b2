import { loadSimplifier } from '../../mesh/detail/loadSimplifier.js';
import { simplifyHatched } from '../../mesh/detail/simplifyHatched.js';
import { lineSpacings } from '../../mesh/features/lineSpacings.js';
import { intersectOutlines } from '../../mesh/intersections/intersectOutlines.js';
import { addDirections } from '../../mesh/occlusion/addDirections.js';
import { startOcclusion } from '../../mesh/occlusion/startOcclusion.js';
import { orientChecked } from '../../mesh/orientation/orientTriangles.js';
import { task } from './task.js';

/** The tasks for scenes that are hatched, and those that few pages need: occlusion, levels of detail, orientation, crowds of lines, lines where parts meet. */
export const sceneTasks = {
  simplifyHatched: /* @__PURE__ */ task(simplifyHatched, ({ simplifier }) => loadSimplifier(simplifier)),
  startOcclusion: /* @__PURE__ */ task(startOcclusion),
  addDirections: /* @__PURE__ */ task(addDirections),
  orientChecked: /* @__PURE__ */ task(orientChecked),
  lineSpacings: /* @__PURE__ */ task(lineSpacings),
  intersectOutlines: /* @__PURE__ */ task(intersectOutlines),
};
