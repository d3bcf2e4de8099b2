import { silence } from './silence.js';

/**
 * Writes a warning to the console, unless the library is silent.
 *
 * @param level `error` if something is not drawn at all
 */
export function warn(sentence: string, level: 'warn' | 'error' = 'warn'): void {
  if (!silence.isOn) console[level](sentence);
}
