import { describeAgainst, runAgainst } from '../against.mjs';

const PLAN = { models: { dragon11k: 25, dragon48k: 25, dragon202k: 15 }, size: 1024 };
const QUICK = { models: { torus5k: 2 }, size: 128 };

/** Frames of engraved lines by what they follow. */
export const lineFields = {
  name: 'lineFields',
  perRasteriser: true,
  run: ({ measure }, isQuick) => runAgainst(measure, 'lineFields', isQuick ? QUICK : PLAN),
  describe: describeAgainst,
};
