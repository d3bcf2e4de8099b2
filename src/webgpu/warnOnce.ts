import { warn } from '../material/diagnostics/warn.js';

const told = new Set<string>();

/** Says a sentence of the material of nodes on the console, unless it was said before. */
export function warnOnce(sentence: string): void {
  if (told.has(sentence)) return;
  told.add(sentence);
  warn(`HatchingNodeMaterial: ${sentence}`);
}
