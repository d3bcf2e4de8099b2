import { median, medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const SCENES = {
  '1,000 meshes': { count: 1000, isInstanced: false },
  '10,000 instances': { count: 10_000, isInstanced: true },
};
const PLAN = { turns: 31, size: 512 };
const QUICK = { turns: 3, size: 128 };

/** What all are compared with. */
const PLAIN = 'lambert';

/** Many small things: how long the script takes beyond three's, and frames beside those of Lambert's shading. */
export const many = {
  name: 'many',
  perRasteriser: true,

  async run({ measure }, isQuick) {
    const { turns, size } = isQuick ? QUICK : PLAN;
    const scenes = {};
    for (const [name, scene] of Object.entries(SCENES)) {
      const { script, frame, first } = await measure('many', scene, turns, size);
      const rows = Object.keys(frame).map((look) => {
        const beyond = median(script[look].map((time, turn) => time - script[PLAIN][turn]));
        return [
          look,
          {
            script: median(script[look]),
            microseconds: scene.isInstanced ? null : (1000 * beyond) / scene.count,
            frame: median(frame[look]),
            ratio: medianInterval(ratios(frame[look], frame[PLAIN])),
            first: first[look],
          },
        ];
      });
      scenes[name] = Object.fromEntries(rows);
    }
    return { turns, size, scenes };
  },

  describe({ turns, size, scenes }) {
    return `Icosahedra; ${turns} turns. Script: of \`renderer.render\` alone, on a canvas of 64 × 64 pixels. Frames: ${size} × ${size} pixels, with ratios to
Lambert's shading of the same geometry; the first with its programs compiled.

${table([
  ['', '', 'script, ms', 'beyond three, µs a mesh', 'frame, ms', 'to lambert', 'first frame, ms'],
  ...Object.entries(scenes).flatMap(([name, rows]) =>
    Object.entries(rows).map(([look, { script, microseconds, frame, ratio, first }]) => [
      name,
      look,
      figure(script),
      microseconds === null || look === PLAIN ? '' : figure(microseconds),
      figure(frame),
      withInterval(ratio),
      figure(first),
    ]),
  ),
])}`;
  },
};
