/** Whether warnings are turned off; `HatchingMaterial.silent` sets it. */
export const silence = { isOn: false };

/**
 * Writes a warning to the console, unless the library is silent.
 *
 * @param level `error` if something is not drawn at all
 */
export function warn(sentence: string, level: 'warn' | 'error' = 'warn'): void {
  if (!silence.isOn) console[level](sentence);
}
