import type { Vec3 } from '../../../../src/look/vectors.js';
import { cutFor, cutWidth, rowOctaves } from '../../../../src/vector/shading/carving.js';
import { handWidth } from '../../../../src/vector/shading/hand.js';
import { penFor, strokeAt } from '../../../../src/vector/shading/penStrokes.js';
import { octaveOf, powerOf2, roomOf } from '../../../../src/vector/shading/ruledLines.js';
import { changePerPixel, type ScreenMap } from '../../../../src/vector/shading/screenGradient.js';
import { alongLines } from '../../../../src/vector/shading/strokeLengths.js';
import type { EngravedSettings } from '../../../reference/engravedReference.js';

/** A family of lines at a fragment. */
export interface SeenFamily {
  value: number;
  gradient: Vec3;
  rise: number;
  coarsest: number;
}

/** A fragment: its position in tiles from the centre, before the hand displaces it. */
export interface SeenFragment {
  map: ScreenMap;
  point: Vec3;
  normal: Vec3;
}

/** As in `lineCoverage.glsl`. */
const coverage = (away: number, half: number): number =>
  Math.min(Math.max(Math.max(half, 0.5) + 0.5 - away, 0), 1) * Math.min(2 * half, 1);

const rankOf = (line: number): number => {
  let rank = -40;
  while (rank < 60 && Number.isInteger(line / 2 ** (rank + 1))) rank++;
  return rank;
};

/** The darkness of a family in its medium, from the functions of the processor. tone: with the pressure of the hand. */
export function familyDarkness(
  { value, gradient, rise, coarsest }: SeenFamily,
  tone: number,
  { lineSpacing, sizedOnScreen, strokeLength, handmade, medium, form }: EngravedSettings,
  { map, point, normal }: SeenFragment,
): number {
  const perPixel = changePerPixel(gradient, map);
  const plain = octaveOf({ lineSpacing, finestSpacing: 3, sizedOnScreen }, rise, perPixel, Infinity);
  const octave = Math.min(plain + (medium === 'woodcut' ? rowOctaves(tone) : 0), coarsest);
  const along = alongLines(point, normal, gradient, map, { strokeLength, sizedOnScreen });
  const repeat = form ? powerOf2(coarsest) : Infinity;
  const step = 2 ** (Math.ceil(octave) - 1);
  let covered = 0;
  for (let k = Math.floor(value / step) - 3; k <= value / step + 4; k++) {
    const line = k * step;
    const room = roomOf(rankOf(line), octave);
    let [width, away] = [room * tone * (form ? 1 : handWidth(line, handmade)), value - line];
    if (medium === 'woodcut') width = room * cutWidth(cutFor(tone, along, repeat, octave), line);
    if (medium === 'pen') {
      const spacing = powerOf2(octave);
      const stroke = strokeAt(penFor(tone, along, handmade, repeat, octave), room / spacing, line);
      width = spacing * stroke.width;
      away -= spacing * stroke.astray;
    }
    covered += coverage(Math.abs(away) / perPixel, (0.5 * width) / perPixel);
  }
  return medium === 'woodcut' ? 1 - Math.min(covered, 1) : Math.min(covered, 1);
}
