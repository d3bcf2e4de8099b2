import type { Task } from '../../worker/TaskSet.js';
import type { DrawingPlan, DrawnScene } from '../DrawnScene.js';
import { drawLines, type LineDrawing } from '../drawLines.js';

const drawing: Task<{ scene: DrawnScene; plan: DrawingPlan }, LineDrawing> = {
  run: ({ scene, plan }) => drawLines(scene, plan),
  resultBuffers: () => [],
};

/** The tasks of the worker that draws lines. */
export const lineTasks = { drawLines: drawing };
