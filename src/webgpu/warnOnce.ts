import { warn } from '../material/diagnostics/warn.js';

const receivedShadows = new Set<string>();

/** Warns once about HatchingNodeMaterial. */
export function warnOnce(sentence: string): void {
  if (receivedShadows.has(sentence)) return;
  receivedShadows.add(sentence);
  warn(`HatchingNodeMaterial: ${sentence}`);
}
