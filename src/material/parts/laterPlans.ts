import type { Color } from 'three';
import type { PlanScene } from '../exposure/ExposureFit.js';

let code: PlanScene | undefined;
let fetching: Promise<void> | undefined;

/** The code that plans values; undefined until it is fetched. */
export const planCode = (): PlanScene | undefined => code;

/** Fetches the code that plans values, once. After a failure, which is reported, the next call tries again. */
export function fetchPlans(): Promise<void> {
  fetching ??= import('../exposure/planScene.js').then(
    ({ planScene }) => {
      code = planScene;
    },
    (cause: unknown) => {
      fetching = undefined;
      console.error('HatchingMaterial: the code that plans values could not be fetched.', cause);
    },
  );
  return fetching;
}

/** The properties of a look that decide whether it has colours of which values are planned. */
export interface PaintedLook {
  readonly colorHatching?: unknown;
  readonly color?: unknown;
  readonly map?: unknown;
  readonly vertexColors?: unknown;
}

/** Fetches that code if a material draws other colours than white as tones. Of a look that is no material its map alone counts. */
export async function fetchPlansOf({ colorHatching = 0, color, map, vertexColors }: PaintedLook): Promise<void> {
  const hex = (color as Partial<Color> | undefined)?.getHex?.() ?? WHITE;
  if ((colorHatching as number) > 0 && (hex !== WHITE || map || vertexColors)) await fetchPlans();
}

const WHITE = 0xffffff;
