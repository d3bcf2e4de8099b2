import { median, medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const PLAN = {
  game: { counts: { meshes: 200, skins: 20, instances: 5000 }, turns: 15 },
  models: { dragon11k: 15, dragon202k: 9 },
  size: 1024,
};
const QUICK = {
  game: { counts: { meshes: 20, skins: 2, instances: 100 }, turns: 2 },
  models: { torus5k: 2 },
  size: 128,
  looks: ['pen'],
};

/** The drawings of a model, and what each is compared with: three's Phong under the same circumstances. */
const AGAINST = { surface: 'phong', outlines: 'phong', shadow: 'phong in shadow', ground: 'phong on ground' };

/** Presets as `applyHatching` makes them, beside Lambert and Phong. */
export const presets = {
  name: 'presets',
  perRasteriser: true,

  async run({ measure }, isQuick) {
    const { game, models, size, looks = await measure('lookNames') } = isQuick ? QUICK : PLAN;
    const found = { size, game: { ...game, looks: {} }, models: {} };
    for (const look of looks) {
      found.game.looks[look] = ofGame(await measure('game', game.counts, look, game.turns, size), game.counts);
    }
    for (const [model, turns] of Object.entries(models)) {
      found.models[model] = { turns, looks: {} };
      for (const look of looks) {
        const { triangles, times } = await measure('presets', model, look, turns, size);
        found.models[model].triangles = triangles;
        found.models[model].looks[look] = ofModel(times);
      }
    }
    return found;
  },

  describe({ size, game, models }) {
    const ofModels = Object.entries(models).map(
      ([
        model,
        { triangles, turns, looks },
      ]) => `${model}, ${triangles.toLocaleString('en')} triangles, ${turns} turns, ratios to Phong under the same circumstances:

${table([
  ['', 'Phong, ms', 'Lambert', 'surface', 'with outlines', 'in its shadow', 'on a ground'],
  ...Object.entries(looks).map(([look, { phong, lambert, surface, outlines, shadow, ground }]) => [
    look,
    figure(phong),
    ...[lambert, surface, outlines, shadow, ground].map((interval) => withInterval(interval)),
  ]),
])}`,
    );
    const { meshes, skins, instances } = game.counts;
    return `${size} × ${size} pixels.

A game's scene of ${meshes} meshes, ${skins} skins and ${instances.toLocaleString('en')} instances, ${game.turns} turns, while skins and light move; ratios to Lambert:

${table([
  ['', 'Lambert, ms', 'Phong', 'surface', 'with outlines', 'script beyond three, µs a mesh', 'with outlines'],
  ...Object.entries(game.looks).map(([look, { lambert, phong, surface, outlines, script }]) => [
    look,
    figure(lambert),
    ...[phong, surface, outlines].map((interval) => withInterval(interval)),
    ...[script.surface, script.outlines].map((interval) => withInterval(interval, 1)),
  ]),
])}

${ofModels.join('\n\n')}`;
  },
};

function ofModel(times) {
  const to = Object.entries(AGAINST).map(([name, other]) => [name, medianInterval(ratios(times[name], times[other]))]);
  return {
    phong: median(times.phong),
    lambert: medianInterval(ratios(times.lambert, times.phong)),
    ...Object.fromEntries(to),
  };
}

function ofGame({ frame, script }, { meshes, skins }) {
  const toLambert = (name) => medianInterval(ratios(frame[name], frame.lambert));
  const beyond = (name) =>
    medianInterval(script[name].map((time, turn) => (1000 * (time - script.lambert[turn])) / (meshes + skins)));
  return {
    lambert: median(frame.lambert),
    phong: toLambert('phong'),
    surface: toLambert('surface'),
    outlines: toLambert('outlines'),
    script: { surface: beyond('surface'), outlines: beyond('outlines') },
  };
}
