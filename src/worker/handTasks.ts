import type { Hand, HandStroke } from '../strokes/hand/Hand.js';
import { type LearnHandRequest, learnHandSteps } from '../strokes/hand/learnHand.js';
import { type TraceRequest, traceStrokesSteps } from '../strokes/strokeTracing/traceStrokesSteps.js';
import type { Task } from './TaskSet.js';

const learning: Task<LearnHandRequest, Hand> = { run: learnHandSteps };
const tracing: Task<TraceRequest, HandStroke[]> = { run: traceStrokesSteps };

/** The tasks of the worker for hands. It is separate from the worker for bakes and maps, which every page loads. */
export const handTasks = { learnHand: learning, traceStrokes: tracing };
