import { TECHNIQUES, type TechniqueRow } from './techniques.js';

type Techniques = keyof typeof TECHNIQUES;

/** A fact of every technique, by its name. */
export const ofTechniques = (read: (row: TechniqueRow) => string): Record<Techniques, string> =>
  Object.fromEntries(Object.entries(TECHNIQUES).map(([name, row]) => [name, read(row)])) as Record<Techniques, string>;

/** Techniques whose strokes come from a map. */
export const WITH_MAP = Object.entries<TechniqueRow>(TECHNIQUES).flatMap(([name, { map }]) =>
  map === 'none' ? [] : [name],
);
