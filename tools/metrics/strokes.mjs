/**
 * @typedef {import('./handStrokes.js').PicturedWholeness} PicturedWholeness
 * @typedef {import('./handStrokes.js').HandTones} HandTones
 * @typedef {import('./handStrokes.js').HandMotion} HandMotion
 * @typedef {import('./handStrokes.js').NumbersOnWall} NumbersOnWall
 *
 * @typedef {object} StrokeMeasures
 * @property {import('./handStrokes.js').StrokeKind} kind
 * @property {Record<string, Record<string, PicturedWholeness[]>>} whole by model and hand
 * @property {Record<string, PicturedWholeness[]>} atShadows by hand
 * @property {Record<string, Record<string, HandTones>>} tones by surface and hand
 * @property {Record<string, Record<string, HandMotion>>} motion by model and hand, and of `lines`
 * @property {Record<string, NumbersOnWall>} numbers by hand
 */
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const others = join(root, '../shared/models');

/** Hands whose strokes are in one piece on their sheet. */
const WHOLE_HANDS = ['brush', 'reedPen', 'finePen', 'quill', 'feltTip', 'woodcut'];
const ALL_HANDS = [...WHOLE_HANDS, ...['dryBrush', 'ballpoint', 'softPencil', 'crayon', 'scribble', 'etchingNeedle']];
const MODELS = ['sphere', 'torus', 'bunny', 'dragon11k'];
/** Models of other people. */
const FILES = { spot: 'spot.obj', nefertiti: 'nefertiti_lowres.obj' };
const MOVING_MODELS = ['sphere', 'bunny'];
const TONED = ['wall', 'sphere'];
const PARTS = ['whole', 'atShadows', 'tones', 'motion', 'numbers'];
/** Required of every hand and model. */
const LIMITS = { byInk: 0.8, plain: 0.6, tone: 0.02, number: 0.15 };

const HEADING = '## Strokes of hands';
const NEXT = '\n## Drawings as lines';

/**
 * Measures the strokes of hands, prints tables, and returns all figures.
 *
 * @param only names of hands, models and parts of the measure; all if none is named
 * @returns {Promise<StrokeMeasures>}
 */
export async function measureStrokes(page, only = []) {
  const known = [...ALL_HANDS, ...MODELS, ...Object.keys(FILES), 'wall', ...PARTS];
  const wrong = only.find((name) => !known.includes(name));
  if (wrong !== undefined)
    throw new Error(`tools/metrics/strokes.mjs: there is no "${wrong}"; there are ${known.join(', ')}.`);
  const chosen = (names) => {
    const named = names.filter((name) => only.includes(name));
    return named.length > 0 ? named : names;
  };
  const files = Object.entries(FILES).filter(([, file]) => existsSync(join(others, file)));
  const models = Object.fromEntries([
    ...MODELS.map((name) => [name, { name }]),
    ...files.map(([name, file]) => [name, { text: readFileSync(join(others, file), 'utf8') }]),
  ]);
  const parts = chosen(PARTS);
  /** @type {StrokeMeasures} */
  const found = {
    kind: await page.evaluate(() => window.handStrokes.kind),
    ...{ whole: {}, atShadows: {}, tones: {}, motion: {}, numbers: {} },
  };
  const measure = (part, ...rest) => page.evaluate(([part, rest]) => window.handStrokes[part](...rest), [part, rest]);
  if (parts.includes('whole')) {
    for (const model of chosen(Object.keys(models))) {
      found.whole[model] = await measure('wholeness', models[model], chosen(WHOLE_HANDS));
      console.log(
        `${model}: ${chosen(WHOLE_HANDS)
          .map((hand) => wholeOf(hand, found.whole[model][hand]))
          .join('; ')}`,
      );
    }
  }
  if (parts.includes('atShadows')) {
    found.atShadows = await measure('atShadows', chosen(WHOLE_HANDS));
    for (const [hand, pictures] of Object.entries(found.atShadows))
      console.log(`at edges of shadows: ${wholeOf(hand, pictures)}`);
  }
  if (parts.includes('tones')) {
    for (const surface of chosen(TONED)) {
      found.tones[surface] = {};
      for (const hand of chosen(ALL_HANDS)) {
        const tones = await measure('tones', models[surface], hand);
        found.tones[surface][hand] = tones;
        const { error, bias } = meanTone(tones);
        console.log(`${hand} on the ${surface}: blocks off by ${error.toFixed(3)}, tone off by ${bias.toFixed(3)}`);
      }
    }
  }
  if (parts.includes('motion')) {
    for (const model of chosen(MOVING_MODELS)) {
      found.motion[model] = { lines: await measure('motion', models[model], undefined) };
      for (const hand of chosen(WHOLE_HANDS.slice(0, 3))) {
        found.motion[model][hand] = await measure('motion', models[model], hand);
        console.log(`${hand} on the ${model}: ${motionOf(found.motion[model], hand)}`);
      }
    }
  }
  if (parts.includes('numbers')) {
    for (const hand of chosen(WHOLE_HANDS)) {
      found.numbers[hand] = await measure('numbers', hand);
      console.log(`${hand}: ${numbersOf(found.numbers[hand]).join(', ')}`);
    }
  }
  return found;
}

/** The worst of all distances at each tone. @param {PicturedWholeness[]} pictures */
const wholeOf = (hand, pictures) => {
  const { byInk, plain, apart, joined } = worstWhole(pictures);
  return `${hand} ${byInk.toFixed(2)} (${plain.toFixed(2)}), apart ${apart.toFixed(2)}, joined ${joined.toFixed(2)}`;
};

/** The smallest lengths of all pictures that show strokes, and the largest share that touch. @param {PicturedWholeness[]} pictures */
export function worstWhole(pictures) {
  const shown = pictures.filter(({ strokes }) => strokes >= LEAST_STROKES);
  return {
    byInk: Math.min(...shown.map(({ byInk }) => byInk)),
    plain: Math.min(...shown.map(({ plain }) => plain)),
    apart: Math.min(...shown.map(({ apart }) => apart)),
    joined: Math.max(...shown.map(({ joined }) => joined)),
  };
}

/** Fewer strokes than this say nothing. */
const LEAST_STROKES = 20;

/** The means over all tones. @param {HandTones} tones */
export function meanTone(tones) {
  const all = Object.values(tones);
  const mean = (value) => all.reduce((sum, one) => sum + value(one), 0) / all.length;
  return { error: mean(({ error }) => error), bias: mean(({ bias }) => Math.abs(bias)) };
}

/** Changes as multiples of those of lines. @param {Record<string, HandMotion>} motion */
function motionOf(motion, hand) {
  return ['zoom', 'camera', 'light']
    .map((kind) => {
      const { change, popping } = motion[hand][kind];
      return `${kind} ${(change / motion.lines[kind].change).toFixed(2)} of lines, popping ${popping.toFixed(2)} (${motion.lines[kind].popping.toFixed(2)})`;
    })
    .join('; ');
}

/** Lengths and spreads on the wall, of those on the sheet. @param {NumbersOnWall} numbers */
function numbersOf({ sheet, wall }) {
  return COMPARED.map((name) => {
    const value = `${name} ${wall[name].toFixed(3)} (${sheet[name].toFixed(3)})`;
    return isOff(name, sheet[name], wall[name]) ? `**${value}**` : value;
  });
}

/** The numbers that show on a wall in one tone. */
const COMPARED = [
  ...['length', 'lengthSpread', 'curvature', 'taperStart', 'taperEnd', 'width', 'widthSpread', 'wobble'],
  ...['angleSpread', 'spacing', 'spacingSpread', 'clustering', 'overlap'],
];

/** A number that is next to nothing may be off by this: tracing does not tell it. Lengths in millimetres, angles in degrees. */
const LEAST_OFF = {
  ...{ length: 0, lengthSpread: 0.03, curvature: 0.006, taperStart: 0.05, taperEnd: 0.05, width: 0, widthSpread: 0.03 },
  ...{ wobble: 0.02, angleSpread: 0.7, spacing: 0, spacingSpread: 0.05, clustering: 0.04, overlap: 0.04 },
};

/** Whether a number differs by more than is allowed. */
export const isOff = (name, sheet, wall) =>
  Math.abs(wall - sheet) > Math.max(LIMITS.number * Math.abs(sheet), LEAST_OFF[name]);

/** What is not as required, one per line. @param {StrokeMeasures} strokes */
export function missedStrokes({ whole, tones, motion, numbers }) {
  const missed = [];
  for (const [model, hands] of Object.entries(whole)) {
    for (const [hand, pictures] of Object.entries(hands)) {
      const worst = worstWhole(pictures);
      for (const kind of ['byInk', 'plain'])
        if (worst[kind] < LIMITS[kind])
          missed.push(`${hand} on ${model}, ${kind}: ${worst[kind].toFixed(2)}, required ≥ ${LIMITS[kind]}`);
    }
  }
  for (const [surface, hands] of Object.entries(tones)) {
    const all = Object.values(hands).map((one) => meanTone(one).error);
    const error = all.reduce((sum, one) => sum + one, 0) / all.length;
    if (error > LIMITS.tone) missed.push(`blocks on the ${surface}: ${error.toFixed(3)}, required ≤ ${LIMITS.tone}`);
  }
  for (const [model, { lines, ...hands }] of Object.entries(motion)) {
    for (const [hand, moved] of Object.entries(hands))
      for (const [kind, { change }] of Object.entries(moved))
        if (change > lines[kind].change)
          missed.push(
            `${hand} on ${model}, ${kind}: ${(change / lines[kind].change).toFixed(2)} of lines, required ≤ 1`,
          );
  }
  for (const [hand, { sheet, wall }] of Object.entries(numbers)) {
    for (const name of COMPARED)
      if (isOff(name, sheet[name], wall[name]))
        missed.push(`${hand}, ${name}: ${wall[name].toFixed(3)}, on the sheet ${sheet[name].toFixed(3)}`);
  }
  return missed;
}

/** The part of the page of the docs. @param {StrokeMeasures} strokes */
export function describeStrokes({ kind, whole, atShadows, tones, motion, numbers }) {
  const row = (cells) => `| ${cells.join(' | ')} |`;
  const table = (head, rows) =>
    [row(head), row(['---', ...head.slice(1).map(() => '--:')]), ...rows.map(row)].join('\n');
  const marked = (value, isKept) => (isKept ? value.toFixed(2) : `**${value.toFixed(2)}**`);
  const models = Object.keys(whole);
  const hands = Object.keys(whole[models[0]] ?? {});
  const wholeCell = (pictures) => {
    const { byInk, plain, apart, joined } = worstWhole(pictures);
    const lengths = `${marked(byInk, byInk >= LIMITS.byInk)} (${marked(plain, plain >= LIMITS.plain)})`;
    return `${lengths}, ${apart.toFixed(2)}, ${joined.toFixed(2)}`;
  };
  const surfaces = Object.keys(tones);
  const toned = Object.keys(tones[surfaces[0]] ?? {});
  const tonesOf = Object.keys(tones[surfaces[0]]?.[toned[0]] ?? {});
  const kinds = ['zoom', 'camera', 'light'];
  return `${HEADING}

Example hands, drawn ${kind === 'rows' ? 'whole, in rows' : 'from maps'}, with strokes 2.4 pixels wide, without antialiasing.

**Whole.** Pieces of ink at the tones 0.1 and 0.25, from three distances: the length along the centre line that the middle of the ink has, of that
with which strokes were drawn, in brackets the median of all pieces; then the first without pieces longer than two strokes, in which strokes touch, and the share of ink in those.
Each is the worst of six pictures of 900 pixels. Pieces whose middle is within one length of a silhouette are left out. Required: ≥ ${LIMITS.byInk} (≥ ${LIMITS.plain}).

${table(
  ['', ...models],
  hands.map((hand) => [hand, ...models.map((model) => wholeCell(whole[model][hand]))]),
)}

**At the hard edges of shadows.** The same of pieces whose middle is within half a length of the shadow of a bar on a wall, of tones 0.03 and 0.3, and 0.1 and 0.5.
Strokes that end at an edge are shorter: between two thirds and all of their length.

${table(
  ['', 'edges'],
  Object.entries(atShadows).map(([hand, pictures]) => {
    const { byInk, plain, apart, joined } = worstWhole(pictures);
    return [hand, `${byInk.toFixed(2)} (${plain.toFixed(2)}), ${apart.toFixed(2)}, ${joined.toFixed(2)}`];
  }),
)}

**Tone.** How far blocks of 32 pixels are from their tone, in the mean: uneven strokes and wrong tones together, and in brackets wrong tones alone.
Required: ≤ ${LIMITS.tone} in the mean of all. At the tone 0.1 a block holds some two strokes, most of them longer than a block: most of the difference is where they lie.

${surfaces
  .map((surface) =>
    table(
      [surface, ...tonesOf],
      toned.map((hand) => [
        hand,
        ...tonesOf.map((tone) => {
          const { error, bias } = tones[surface][hand][tone];
          return `${error.toFixed(3)} (${bias.toFixed(3)})`;
        }),
      ]),
    ),
  )
  .join('\n\n')}

**Steady.** Mean change of luminance from frame to frame while the camera comes twice as near, goes round by 24°, and the light goes round by 36°, each in 24
frames, of that of lines of a pen; in brackets the largest change over the median, and that of lines.

${table(
  ['', ...Object.keys(motion).flatMap((model) => kinds.map((one) => `${model}, ${one}`))],
  Object.keys(Object.values(motion)[0] ?? {})
    .filter((hand) => hand !== 'lines')
    .map((hand) => [
      hand,
      ...Object.values(motion).flatMap((moved) =>
        kinds.map((one) => {
          const [{ change, popping }, lines] = [moved[hand][one], moved.lines[one]];
          const share = change / lines.change;
          return `${marked(share, share <= 1)} (${popping.toFixed(2)}, ${lines.popping.toFixed(2)})`;
        }),
      ),
    ]),
)}

**Numbers.** A wall as dark as the middle swatch is traced and learnt; in brackets the numbers of the sheet. **Bold** differs by more than ${100 * LIMITS.number} %.

${table(
  ['', ...COMPARED],
  Object.entries(numbers).map(([hand, { sheet, wall }]) => [
    hand,
    ...COMPARED.map((name) => {
      const value = isOff(name, sheet[name], wall[name]) ? `**${wall[name].toFixed(3)}**` : wall[name].toFixed(3);
      return `${value} (${sheet[name].toFixed(3)})`;
    }),
  ]),
)}
`;
}

/** A page of the docs with this part written anew, before the part about drawings as lines. @param {string} page */
export function withStrokes(page, strokes) {
  const end = page.includes(NEXT) ? page.indexOf(NEXT) : page.length;
  const start = page.includes(HEADING) ? page.indexOf(HEADING) : end;
  return `${page.slice(0, start).trimEnd()}\n\n${describeStrokes(strokes)}${page.slice(end)}`;
}
