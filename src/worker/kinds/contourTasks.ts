import { searchContours } from '../../mesh/features/contourCandidates.js';
import { task } from './task.js';

/** The task that searches large meshes for contours, again and again while the camera moves. */
export const contourTasks = { searchContours: /* @__PURE__ */ task(searchContours) };
