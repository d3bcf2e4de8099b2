import type { Engraver } from '../Engraver.js';
import { blackAround, strokeOnLine } from '../lineMarks.js';
import type { Tones } from '../ToneReader.js';
import type { EvenSurface } from './EvenSurface.js';
import type { LineFields } from './LineFields.js';
import type { LinePoints } from './LinePoints.js';
import { familyOf, LAYS } from './layTones.js';

/** Strokes along a line, or its parts in the black of a woodcut. */
export interface LineStrokes {
  /** Per point above 0 where there is a stroke. */
  margins: number[];
  /** Two offsets per point, millimetres. */
  shifts: number[];
}

/** Tones do not matter for where strokes begin and end but by the fields. */
const BLANK: Tones = { tone: 0, unshadowed: 0, shadows: 0, left: 1, full: 0, turned: 0, dark: 0 };

/** The strokes of a pen along a line, or its parts between the cuts of a woodcut; null where the line is drawn in one go. */
export function strokesAlong(
  points: LinePoints,
  line: number,
  { fields, set, surface }: { fields: LineFields; set: number; surface: EvenSurface },
): LineStrokes | null {
  const { technique } = surface.drawn.engraved;
  if (technique === 'engraving') return null;
  const { sheet } = fields;
  const strokes: LineStrokes = { margins: [], shifts: [] };
  for (let i = points.starts[line]; i < points.starts[line + 1]; i++) {
    const [x, y] = [points.x[i], points.y[i]];
    fields.look(set, x, y);
    const place = surface.placeAt(x / sheet.scale, y / sheet.scale, sheet.triangleAt(x, y));
    const engraver: Engraver = surface.engraver(fields.engraverAt(x, y));
    const at = engraver.at(place);
    const family = familyOf(LAYS[set].name, at.cut);
    if (technique === 'woodcut') {
      const { tone } = fields;
      const measure = engraver.measure(family, at, { ...BLANK, tone, unshadowed: tone });
      strokes.margins.push(blackAround({ ...measure, tone }));
      strokes.shifts.push(0, 0);
      continue;
    }
    const measure = engraver.measure(family, at, BLANK);
    const { presence, astray, uphill } = strokeOnLine({ ...measure, tone: fields.tone }, points.ids[line]);
    strokes.margins.push(presence - 0.5);
    strokes.shifts.push(...uphill.map((way) => points.apart[i] * astray * way));
  }
  return strokes;
}
