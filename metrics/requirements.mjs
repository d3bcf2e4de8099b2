/**
 * @typedef {import('./page.js').ModelMetrics} ModelMetrics
 * @typedef {import('./page.js').TechniqueMetrics} TechniqueMetrics
 *
 * @typedef {object} Requirement
 * @property {string} name
 * @property {number} limit - what `anchored` must not exceed, or reach if `atLeast`.
 * @property {boolean} [atLeast]
 * @property {(models: Record<string, ModelMetrics>, technique: string) => { value: number, model: string } | undefined} worst
 *   - the worst value of a technique and the model it occurs on; undefined where it was not measured.
 */

const LIGHT_TURN = 0.5;

/** What is required of `anchored`, and how each value follows from the measurements. */
export const requirements = /** @type {Requirement[]} */ ([
  { name: 'Greyness: share of pixels neither ink nor paper', limit: 0.005, worst: largest((m) => m.greyness) },
  { name: 'Mean jump of luminance across shared edges', limit: 1e-3, worst: largest((m) => m.edgeJump?.mean) },
  { name: 'Tone error, worst of five tones', limit: 0.02, worst: largest(toneError) },
  {
    name: 'Flips under a 0.5° turn of the light, against those of `adjacency`',
    limit: 1 / 3,
    worst: (models, technique) =>
      // On a sphere about its own origin the coordinates of Suarez et al. hardly depend on the light, nor on the place.
      largest((m, name) => (name === 'sphere' ? undefined : flipsAt(m) / flipsAt(models[name].techniques.adjacency)))(
        models,
        technique,
      ),
  },
  { name: 'Popping index of a camera coming 8 times nearer', limit: 2, worst: largest((m) => m.dolly?.popping) },
  { name: 'Stroke spacing in pixels during that move, ±', limit: 0.15, worst: largest((m) => m.zoom?.spread) },
  {
    name: 'Coherence on the dragon of 871 k triangles, against that of 11 k',
    limit: 0.95,
    atLeast: true,
    worst: ({ dragon11k, dragon871k }, technique) =>
      dragon11k &&
      dragon871k && {
        value: dragon871k.techniques[technique].coherence / dragon11k.techniques[technique].coherence,
        model: 'dragon871k',
      },
  },
]);

/** @param {TechniqueMetrics} metrics */
export function toneError({ ink }) {
  return Math.max(...Object.entries(ink).map(([tone, mean]) => Math.abs(mean - Number(tone))));
}

/** Normalised flips under the turn of the light that is required. @param {TechniqueMetrics} metrics */
export function flipsAt({ light }, turn = LIGHT_TURN) {
  return light?.flips.find(({ degrees }) => degrees === turn)?.share;
}

/** @param {(metrics: TechniqueMetrics, model: string) => number | undefined} figure */
function largest(figure) {
  return (/** @type {Record<string, ModelMetrics>} */ models, /** @type {string} */ technique) =>
    Object.entries(models)
      .map(([model, { techniques }]) => ({ model, value: figure(techniques[technique], model) }))
      .filter(({ value }) => Number.isFinite(value))
      .sort((a, b) => b.value - a.value)[0];
}
