import { bakeIndexed } from '../../mesh/bake/bakeIndexed.js';
import { task } from './task.js';

/** The task that bakes geometries whose triangles need no adjacency: most pages bake nothing else. */
export const indexedTasks = { bakeIndexed: /* @__PURE__ */ task(bakeIndexed) };
