import { medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';
import { allocations, SAMPLING } from './allocations.mjs';

const SCENES = {
  '1,000 meshes': { count: 1000, isInstanced: false },
  '10,000 instances': { count: 10_000, isInstanced: true },
};
/** `share`: of what the names of the scenes say. */
const PLAN = { share: 1, turns: 31, size: 512, garbageFrames: 200 };
const QUICK = { share: 0.05, turns: 2, size: 128, garbageFrames: 2 };

/** The baseline of the comparison. */
const PLAIN = 'lambert';

/**
 * Many small objects: the time of the script beyond three's, its garbage, and frames compared with those of
 * Lambert's shading.
 */
export const many = {
  name: 'many',
  perRasteriser: true,

  async run({ openMeasuring }, isQuick) {
    const { share, turns, size, garbageFrames } = isQuick ? QUICK : PLAN;
    const scenes = {};
    for (const [name, whole] of Object.entries(SCENES)) {
      const scene = { ...whole, count: share * whole.count };
      const { page, measure } = await openMeasuring();
      const { script, frame, first } = await measure('many', scene, turns, size);
      const rows = [];
      for (const look of Object.keys(frame)) {
        const beyond = script[look].map((time, turn) => (1000 * (time - script[PLAIN][turn])) / scene.count);
        rows.push([
          look,
          {
            script: medianInterval(script[look])[0],
            microseconds: scene.isInstanced ? null : medianInterval(beyond)[0],
            interval: scene.isInstanced ? null : medianInterval(beyond).slice(1),
            garbage: scene.isInstanced ? undefined : await garbageOf(page, measure, look, garbageFrames),
            frame: medianInterval(frame[look])[0],
            ratio: medianInterval(ratios(frame[look], frame[PLAIN])),
            first: first[look],
          },
        ]);
      }
      await page.close();
      scenes[name] = Object.fromEntries(rows);
    }
    return { share, turns, size, garbageFrames, scenes };
  },

  describe({ share, turns, size, garbageFrames, scenes }) {
    return `Icosahedra${share < 1 ? `, of which ${figure(100 * share)} % are there` : ''}; ${turns} turns. Script: of \`renderer.render\` alone, on a canvas of 64 × 64 pixels. Garbage: what functions of the library
allocate, and what these call, a frame, over ${garbageFrames} frames. Frames: ${size} × ${size} pixels, with ratios to Lambert's shading of the
same geometry, which covers the same pixels; the first with its programs compiled.

${table([
  ['', '', 'script, ms', 'beyond three, µs a mesh', 'garbage, bytes', 'frame, ms', 'to lambert', 'first frame, ms'],
  ...Object.entries(scenes).flatMap(([name, rows]) =>
    Object.entries(rows).map(([look, { script, microseconds, garbage, frame, ratio, first }]) => [
      name,
      look,
      figure(script),
      microseconds === null || look === PLAIN ? '' : figure(microseconds),
      figure(garbage),
      figure(frame),
      withInterval(ratio),
      figure(first),
    ]),
  ),
])}`;
  },
};

/** The bytes a frame, once all is compiled. */
async function garbageOf(page, measure, look, frames) {
  const session = await page.context().newCDPSession(page);
  await measure('manyFrames', look, frames);
  await session.send('HeapProfiler.enable');
  await session.send('HeapProfiler.startSampling', SAMPLING);
  await measure('manyFrames', look, frames);
  const { profile } = await session.send('HeapProfiler.stopSampling');
  await session.detach();
  // The page that measures allocates too, but lies in no folder of the library.
  return [...allocations(profile).values()].reduce((sum, bytes) => sum + bytes, 0) / frames;
}
