import type { HandStroke } from '../hand/Hand.js';
import { type TraceRequest, traceStrokesSteps } from '../scan/traceStrokesSteps.js';
import type { Task } from '../worker/TaskSet.js';

const tracing: Task<TraceRequest, HandStroke[]> = {
  run: traceStrokesSteps,
  resultBuffers: () => [],
};

/** All tasks of the worker that traces strokes. */
export const scanTasks = { traceStrokes: tracing };
