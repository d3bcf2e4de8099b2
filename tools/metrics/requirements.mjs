/**
 * @typedef {import('./page.js').ModelMetrics} ModelMetrics
 * @typedef {import('./page.js').TechniqueMetrics} TechniqueMetrics
 *
 * @typedef {object} Requirement
 * @property {string} name
 * @property {Record<string, number>} limits - what each technique must not exceed, or reach if `atLeast`; nothing is required of others.
 * @property {boolean} [atLeast]
 * @property {(models: Record<string, ModelMetrics>, technique: string) => { value: number, model: string } | undefined} worst
 *   - the worst value of a technique and the model it occurs on; undefined where it was not measured.
 */

const LIGHT_TURN = 0.5;

/** Engraved lines that never move double their number; so their distance goes from √½ to √2 of its middle. */
const OCTAVE = 1 / 3;

/** The requirements, with the computation of each value from the measurements. */
export const requirements = /** @type {Requirement[]} */ ([
  {
    name: 'Greyness: share of pixels neither ink nor paper',
    limits: { hatching: 0.005 },
    worst: largest((m) => m.greyness),
  },
  {
    name: 'Mean jump of luminance across shared edges',
    limits: { hatching: 1e-3, engraving: 1e-3, 'engraving, x': 1e-3 },
    worst: largest((m) => m.edgeJump?.mean),
  },
  {
    name: 'Tone error, worst of five tones',
    limits: { hatching: 0.02, engraving: 0.02, 'engraving, x': 0.02, 'engraving, form': 0.01 },
    worst: largest(toneError),
  },
  {
    name: 'Flips under a 0.5° turn of the light, against those of `adjacency`',
    limits: { hatching: 1 / 3, 'engraving, x': 0, 'engraving, form': 0 },
    worst: (models, technique) =>
      // The coordinates of Suarez et al. hardly depend on light and place on a sphere about its own origin.
      largest((m, name) => (name === 'sphere' ? undefined : flipsAt(m) / flipsAt(models[name].techniques.adjacency)))(
        models,
        technique,
      ),
  },
  {
    name: 'Popping index of a camera coming 8 times nearer',
    limits: { hatching: 2, engraving: 1.5 },
    worst: largest((m) => m.dolly?.popping),
  },
  {
    name: 'Popping index by luminance',
    limits: { engraving: 1.5, 'engraving, x': 1.5, 'engraving, form': 1.5 },
    worst: largest((m) => m.dolly?.luminancePopping),
  },
  {
    name: 'Stroke spacing in pixels during that move, ±',
    limits: { hatching: 0.15, engraving: OCTAVE, 'engraving, x': OCTAVE, 'engraving, form': OCTAVE },
    worst: largest((m) => m.zoom?.spread),
  },
  {
    name: 'Stroke spacing 1, 2, 4 and 8 times as near, ±',
    limits: { engraving: 0.1, 'engraving, x': 0.1, 'engraving, form': 0.1 },
    worst: largest((m) => m.zoom?.octaveSpread),
  },
  {
    name: 'Coherence',
    limits: { engraving: 0.9, 'engraving, x': 0.9, 'engraving, form': 0.9 },
    atLeast: true,
    worst: smallest((m) => m.coherence),
  },
  {
    name: 'Length of strokes on the sphere and the bunny, of that of the map',
    limits: { hatching: 0.7 },
    atLeast: true,
    // Only where the direction changes little along a stroke.
    worst: ({ sphere, bunny }, technique) =>
      Object.entries({ sphere, bunny })
        .filter(([, model]) => model)
        .map(([model, { techniques }]) => ({ model, value: techniques[technique].strokeLength }))
        .sort((a, b) => a.value - b.value)[0],
  },
  {
    name: 'Coherence on the dragon of 871 k triangles, against that of 11 k',
    limits: { hatching: 0.95, engraving: 0.95, 'engraving, x': 0.95, 'engraving, form': 0.95 },
    atLeast: true,
    worst: ({ dragon11k, dragon871k }, technique) =>
      dragon11k &&
      dragon871k && {
        value: dragon871k.techniques[technique].coherence / dragon11k.techniques[technique].coherence,
        model: 'dragon871k',
      },
  },
]);

/** Whether a value is what is required of a technique. @param {Requirement} requirement */
export const isKept = ({ limits, atLeast }, technique, value) =>
  atLeast ? value >= limits[technique] : value <= limits[technique];

/** @param {TechniqueMetrics} metrics */
export function toneError({ ink }) {
  return Math.max(...Object.entries(ink).map(([tone, mean]) => Math.abs(mean - Number(tone))));
}

/** Normalised flips under the turn of the light that is required. @param {TechniqueMetrics} metrics */
export function flipsAt({ light }, turn = LIGHT_TURN) {
  return light?.flips.find(({ degrees }) => degrees === turn)?.share;
}

/** @param {(metrics: TechniqueMetrics, model: string) => number | undefined} figure */
function sorted(figure) {
  return (/** @type {Record<string, ModelMetrics>} */ models, /** @type {string} */ technique) =>
    Object.entries(models)
      .map(([model, { techniques }]) => ({ model, value: figure(techniques[technique], model) }))
      .filter(({ value }) => Number.isFinite(value))
      .sort((a, b) => b.value - a.value);
}

/** @param {Parameters<typeof sorted>[0]} figure */
function largest(figure) {
  return (/** @type {Record<string, ModelMetrics>} */ models, /** @type {string} */ technique) =>
    sorted(figure)(models, technique)[0];
}

/** @param {Parameters<typeof sorted>[0]} figure */
function smallest(figure) {
  return (/** @type {Record<string, ModelMetrics>} */ models, /** @type {string} */ technique) =>
    sorted(figure)(models, technique).at(-1);
}
