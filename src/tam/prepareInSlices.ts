import type { MapDrawing } from '../hatchImages/hatchImageOptions.js';
import type { MapRequest } from '../hatchImages/hatchImageRequest.js';
import { requestOfHand } from '../hatchImages/requestOfHand.js';
import { runSliced } from '../slices/runSliced.js';

/** Prepares a map of a hand for the worker, in slices. */
export const prepareInSlices = (drawing: MapDrawing, signal: AbortSignal | undefined): Promise<MapRequest> =>
  runSliced(requestOfHand(drawing), { signal });
