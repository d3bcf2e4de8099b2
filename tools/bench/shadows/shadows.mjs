import { describeAgainst, runAgainst } from '../against.mjs';

const PLAN = { models: { dragon11k: 25, dragon48k: 25 }, size: 1024 };
const QUICK = { models: { torus5k: 2 }, size: 128 };

/** The cost of shadows: on a model that casts shadows on itself, and on a ground that shows only shadows. */
export const shadows = {
  name: 'shadows',
  perRasteriser: true,
  run: ({ measure }, isQuick) => runAgainst(measure, 'shadows', isQuick ? QUICK : PLAN),
  describe: describeAgainst,
};
