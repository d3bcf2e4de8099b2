import { runSliced } from '../../mesh/runSliced.js';
import { requestOfHand } from '../../strokes/handStyle.js';
import type { MapRequest } from '../../strokes/tamImages/generateHatchImages.js';
import type { MapDrawing } from '../../strokes/tamImages/hatchImageOptions.js';

/** Prepares the request for a map of a hand, in slices. */
export const prepareInSlices = (drawing: MapDrawing, signal: AbortSignal | undefined): Promise<MapRequest> =>
  runSliced(requestOfHand(drawing), { signal });
