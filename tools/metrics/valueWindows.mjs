/**
 * @typedef {import('./valueShares.js').ModelValues} ModelValues
 * @typedef {import('./valueShares.js').ValueShares} ValueShares
 */

/** The least and the most of a model that may be paper, half tone and dark: some of each, and no more dark than a dark thing has. */
const INKED = { paper: [0.03, 0.6], half: [0.05, 0.65], dark: [0.25, 0.85] };

/** Windows of the other presets. */
const OTHERS = {
  // Woodcuts are black and white.
  woodcut: { ...INKED, half: [0.03, 0.6], dark: [0.25, 0.87] },
  // Light parts are covered, and dark ones left blank.
  chalk: { paper: [0, 0.85], half: [0.05, 0.5], dark: [0.09, 0.72] },
};

/** Values outside the window of their preset, one per line. @param {Record<string, ModelValues>} values */
export function missedValues(values) {
  const lines = [];
  for (const [model, presets] of Object.entries(values)) {
    for (const [preset, { auto }] of Object.entries(presets)) {
      for (const [value, [least, most]] of Object.entries(OTHERS[preset] ?? INKED)) {
        if (auto[value] >= least && auto[value] <= most) continue;
        lines.push(`${preset} of ${model}: ${auto[value].toFixed(2)} ${value}, required ${least} to ${most}`);
      }
    }
  }
  return lines;
}
