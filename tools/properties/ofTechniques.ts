import type { TechniqueFamily } from '../../src/look/HatchingProperty.js';
import { TECHNIQUES, type TechniqueName, type TechniqueRow } from './techniques.js';

const ROWS = Object.entries<TechniqueRow>(TECHNIQUES) as [TechniqueName, TechniqueRow][];

/** A fact of every technique, by its name. */
export const ofTechniques = <Value>(read: (row: TechniqueRow) => Value): Record<TechniqueName, Value> =>
  Object.fromEntries(ROWS.map(([name, row]) => [name, read(row)])) as Record<TechniqueName, Value>;

/** The techniques of some families. */
export const inFamilies = (...families: readonly TechniqueFamily[]): TechniqueName[] =>
  ROWS.flatMap(([name, { family }]) => (families.includes(family) ? [name] : []));

export const PER_TRIANGLE = inFamilies('perTriangle');
export const STROKES_FAMILY = inFamilies('strokes');
export const LINES_FAMILY = inFamilies('lines');

/** Techniques whose strokes come from a map. */
export const WITH_MAP = ROWS.flatMap(([name, { map }]) => (map === 'none' ? [] : [name]));
