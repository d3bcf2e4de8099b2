import { generateHatchImages } from '../../strokes/tamImages/generateHatchImages.js';
import { generateThresholds } from '../../strokes/tamImages/generateThresholds.js';
import { completeHatchImages } from '../../strokes/tamImages/makeLevels.js';
import { task } from './task.js';

/** The tasks that draw the images of maps. */
export const mapTasks = {
  generateHatchImages: /* @__PURE__ */ task(generateHatchImages),
  generateThresholds: /* @__PURE__ */ task(generateThresholds),
  completeHatchImages: /* @__PURE__ */ task(completeHatchImages),
};
