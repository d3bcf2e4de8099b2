import type { Engraver } from './Engraver.js';
import type { LineSurface } from './LineSurface.js';
import type { Projection } from './Projection.js';
import type { PlaceReader } from './paint/PlaceReader.js';
import type { Toner } from './Toner.js';

/** What the lines of a surface are traced with. */
export interface Tracing {
  surface: LineSurface;
  places: PlaceReader;
  engraver: Engraver;
  toner: Toner;
  projection: Projection;
  /** Per triangle 1 where its front is seen, −1 where its back is, 0 where nothing is drawn of it. */
  sides: Int8Array;
  /** The width of a pen, pixels; null where widths are the tone. */
  pen: number | null;
  /** Whether lines are drawn where these lights do not arrive, as bits; null where shadows do not matter to that. */
  isDrawnIn: ((shadows: number) => boolean) | null;
}
