/** @typedef {import('./sceneValues.js').SceneValues} SceneValues */

/**
 * What is asked of planned values: paper and solid dark as shares of what is seen, and borders that are told apart. Where the light leaves
 * little paper on a white model, half of that is enough.
 */
const LEAST_PAPER = 0.3;
const OF_WHITE = 0.5;
const MOST_SOLID = 0.15;
const LEAST_TOLD = 0.95;

const share = (value) => `${(100 * value).toFixed(0)} %`.padStart(5);

/** A table of scenes. @param {Record<string, Record<'planned' | 'measured', SceneValues>>} scenes */
export const describeScenes = (scenes) => [
  'scene        values    paper  white  solid  least step  told apart  darkest at',
  ...Object.entries(scenes).flatMap(([name, kinds]) =>
    Object.entries(kinds).map(([kind, { paper, ifWhite, solid, leastStep, told, darkest, isOnSubject }]) =>
      [
        name.padEnd(12),
        kind.padEnd(9),
        share(paper),
        '',
        share(ifWhite),
        '',
        share(solid),
        leastStep.toFixed(2).padStart(11),
        share(told).padStart(11),
        ` ${darkest.map((at) => at.toFixed(2)).join(', ')}${isOnSubject ? '' : ' (beside the subject)'}`,
      ].join(' '),
    ),
  ),
];

/** What planned values miss, one per line. @param {Record<string, Record<'planned' | 'measured', SceneValues>>} scenes */
export const missedScenes = (scenes) =>
  Object.entries(scenes).flatMap(
    ([
      name,
      {
        planned: { paper, ifWhite, solid, told, isOnSubject },
      },
    ]) => [
      ...(paper < Math.min(LEAST_PAPER, OF_WHITE * ifWhite)
        ? [`${name}: ${share(paper)} paper, required ${share(Math.min(LEAST_PAPER, OF_WHITE * ifWhite))}`]
        : []),
      ...(solid > MOST_SOLID ? [`${name}: ${share(solid)} solid dark, required at most ${share(MOST_SOLID)}`] : []),
      ...(told < LEAST_TOLD
        ? [`${name}: ${share(told)} of its borders told apart, required ${share(LEAST_TOLD)}`]
        : []),
      ...(isOnSubject ? [] : [`${name}: the darkest mass is beside the subject`]),
    ],
  );
