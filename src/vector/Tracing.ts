import type { Engraver } from './Engraver.js';
import type { LineSurface } from './LineSurface.js';
import type { Projection } from './Projection.js';
import type { PlaceReader } from './paint/PlaceReader.js';
import type { Toner } from './Toner.js';

/** The inputs for tracing the lines of a surface. */
export interface Tracing {
  surface: LineSurface;
  places: PlaceReader;
  engraver: Engraver;
  toner: Toner;
  projection: Projection;
  /** Per triangle 1 if its front is visible, −1 if its back is, 0 if nothing of it is drawn. */
  sides: Int8Array;
  /** The width of a pen, pixels; null where widths are the tone. */
  pen: number | null;
  /** Whether lines are drawn where these lights (bits) do not arrive; null where they do not depend on shadows. */
  isDrawnIn: ((shadows: number) => boolean) | null;
}
