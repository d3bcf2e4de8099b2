import { inGroup, type NumberRow } from './Setting.js';

const DRAWN = { outlines: ['on'] } as const;

/** A slider for the weight of one kind of outline. */
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
export const OUTLINE_SETTINGS = inGroup('Outlines', 'hand', {
  outlines: { kind: 'choice', label: 'Outlines', default: 'on', choices: { on: 'Drawn', off: 'None' } },
  outlineWidth: {
    kind: 'number',
    label: 'Outline width',
    when: DRAWN,
    default: 1.8,
    unit: 'px',
    min: 0.4,
    max: 8,
    step: 0.1,
  },
  outlineContours: weight('Contours', 100),
  outlineInner: weight('Inner contours', 50, { max: 100 }),
  outlineBorders: weight('Borders', 100),
  outlineCreases: weight('Creases', 35),
  outlineSuggestive: weight('Suggestive', 0, { ends: ['none', 'in folds'] }),
  outlineShade: weight('Shade', 40, { max: 100, step: 1, ends: ['even', 'thin in light'] }),
  outlineLost: weight('Lost edges', 20, { max: 100, ends: ['closed', 'open in light'] }),
  outlineAccents: weight('Accents', 50, { ends: ['none', 'where forms overlap'] }),
  outlineHidden: {
    kind: 'choice',
    label: 'Hidden',
    when: DRAWN,
    default: 'none',
    choices: { none: 'Not drawn', dashed: 'Dashed', faint: 'Faint' },
  },
  outlineHand: {
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
