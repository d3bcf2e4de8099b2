import { inGroup, type NumberRow } from './Setting.js';

const DRAWN = { lines: ['on'] } as const;

/** How much lines of a kind weigh. */
const weight = (label: string, fallback: number, added: Partial<NumberRow> = {}): NumberRow => ({
  kind: 'number',
  label,
  when: DRAWN,
  default: fallback,
  unit: '%',
  min: 0,
  max: 200,
  step: 5,
  ...added,
});

/** Contours, creases and the like. */
export const LINE_SETTINGS = inGroup('Lines', 'hand', {
  lines: { kind: 'choice', label: 'Lines', default: 'on', choices: { on: 'Drawn', off: 'None' } },
  lineWidth: {
    kind: 'number',
    label: 'Line width',
    when: DRAWN,
    default: 1.8,
    unit: 'px',
    min: 0.4,
    max: 8,
    step: 0.1,
  },
  lineContours: weight('Contours', 100),
  lineBorders: weight('Borders', 100),
  lineCreases: weight('Creases', 60),
  lineSuggestive: weight('Suggestive', 0, { ends: ['none', 'in folds'] }),
  lineShade: weight('Shade', 50, { max: 100, step: 1, ends: ['even', 'lost in light'] }),
  lineHand: {
    kind: 'number',
    label: 'Hand',
    when: DRAWN,
    default: 0.5,
    unit: 'px',
    min: 0,
    max: 4,
    step: 0.1,
    ends: ['ruled', 'loose'],
  },
});
