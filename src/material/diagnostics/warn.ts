import { silence } from './silence.js';

/**
 * Says a sentence about a mistake on the console, unless the library was told to be silent.
 *
 * @param level `error` where something is not drawn at all
 */
export function warn(sentence: string, level: 'warn' | 'error' = 'warn'): void {
  if (!silence.isOn) console[level](sentence);
}
