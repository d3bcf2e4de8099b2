import { median, medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const PLAN = { models: { dragon11k: 25, dragon48k: 25, dragon871k: 15 }, size: 1024 };
const QUICK = { models: { dragon11k: 2 }, size: 128 };

/** The baseline of the comparison. */
const PHONG = 'phong';

/** Frames of `HatchingNodeMaterial` beside three's Phong material, of WebGPURenderer on WebGL 2 and on WebGPU. */
export const nodes = {
  name: 'nodes',
  perRasteriser: true,

  async run({ measure }, isQuick) {
    const { models, size } = isQuick ? QUICK : PLAN;
    // A GPU's own clock is that of WebGL: what WebGPU draws there is not timed.
    const adapter = process.env.HATCH_RASTERISER === 'gpu' ? null : await measure('describeAdapter');
    const backends = {};
    for (const backend of adapter ? ['forceWebGL', 'webgpu'] : ['forceWebGL']) {
      backends[backend] = {};
      for (const [model, turns] of Object.entries(models)) {
        const { triangles, times } = await measure('nodes', model, backend, turns, size);
        const drawn = Object.entries(times).map(([name, list]) => [
          name,
          { ms: median(list), ratio: medianInterval(ratios(list, times[PHONG])) },
        ]);
        backends[backend][model] = { triangles, turns, drawn: Object.fromEntries(drawn) };
      }
    }
    return { size, adapter, backends };
  },

  describe({ size, adapter, backends }) {
    const rows = Object.entries(backends).flatMap(([backend, models]) =>
      Object.entries(models).map(([model, { triangles, turns, drawn }]) => [
        backend === 'webgpu' ? 'WebGPU' : '`forceWebGL`',
        model,
        triangles.toLocaleString('en'),
        String(turns),
        figure(drawn[PHONG].ms),
        ...Object.keys(drawn)
          .filter((name) => name !== PHONG)
          .map((name) => withInterval(drawn[name].ratio)),
      ]),
    );
    const [{ drawn }] = Object.values(Object.values(backends)[0]);
    const names = Object.keys(drawn).filter((name) => name !== PHONG);
    return `${size} × ${size} pixels, layout \`indexed\`; ratios to Phong. \`hatching\` and \`engraving\` are plain, \`pencil\` and \`engraving\` the presets.

${table([['', '', 'triangles', 'turns', 'Phong, ms', ...names], ...rows])}

${adapter ? `WebGPU is drawn by ${adapter}.` : 'WebGPU was not timed.'}`;
  },
};
