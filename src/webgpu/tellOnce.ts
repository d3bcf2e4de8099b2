import { tell } from '../material/diagnostics/tell.js';

const told = new Set<string>();

/** Says a sentence of the material of nodes on the console, unless it was said before. */
export function tellOnce(sentence: string): void {
  if (told.has(sentence)) return;
  told.add(sentence);
  tell(`HatchingNodeMaterial: ${sentence}`);
}
