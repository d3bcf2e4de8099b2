import { warn } from '../material/diagnostics/warn.js';

const warned = new Set<string>();

/** Warns once about HatchingNodeMaterial. */
export function warnOnce(sentence: string): void {
  if (warned.has(sentence)) return;
  warned.add(sentence);
  warn(`HatchingNodeMaterial: ${sentence}`);
}
