/** `toneModel` as `TONE_MODEL`. */
export const constantCase = (name: string): string => name.replace(/([A-Z])/g, '_$1').toUpperCase();
