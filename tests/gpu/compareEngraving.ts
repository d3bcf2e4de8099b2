import type { HandNumbers } from '../../src/strokes/hand/Hand.js';
import { learnHand } from '../../src/strokes/hand/learnHand.js';
import { drawSwatches } from '../../src/strokes/hands/drawSwatch.js';
import { exampleHabits } from '../../src/strokes/hands/exampleHabits.js';
import { quickOnly } from '../browser/quickIf.js';
import type { TestOnOnePage } from '../browser/test.js';
import type { ReferenceLight } from '../reference/hatchingReference.js';
import { torus } from '../reference/meshes.js';
import { engravingDarkness } from './engravingDarkness.js';
import type { HatchingSpec, LineSettings } from './hatchingSpec.js';
import { centreOf, expectDarkness, type ReferenceCase, referenceOf, specOf } from './referenceCase.js';
import {
  ambient,
  blocked,
  crossed,
  directional,
  hemisphere,
  leaning,
  mirrored,
  moved,
  movedBack,
  placed,
  redSide,
  rotated,
  squashed,
  wall,
} from './referenceScenes.js';

interface EngravedCase extends ReferenceCase {
  lines?: Partial<LineSettings>;
}

const fromAbove: ReferenceLight = { ...directional, position: [0.2, 3, 0.3] };

const lamp: ReferenceLight = { type: 'point', color: [20, 20, 20], position: [1.2, 1.5, 2], distance: 0, decay: 2 };
const spot: ReferenceLight = {
  type: 'spot',
  color: [12, 9, 6],
  position: [-2, 1, 2],
  target: [0, 0, 0],
  distance: 0,
  decay: 2,
  angle: 0.7,
  penumbra: 0.3,
};

/** Functions that are quadratic in space are so within every triangle. Their lines lie about as far apart as those of a bake. */
const form: NonNullable<LineSettings['form']> = [
  { linear: [1.5, 5, 0.5], squares: [1.2, -0.6, 0.4] },
  { linear: [4.5, -2.2, 1], squares: [0, 0.5, -0.3] },
];

/** A hand with bundles, gaps and slants, whose strokes cross. */
const reedPen = learnHand(drawSwatches(exampleHabits.reedPen, 1));
const handWith = (numbers: Partial<HandNumbers>): LineSettings['hand'] => ({
  ...reedPen,
  numbers: { ...reedPen.numbers, ...numbers },
});
const hand = handWith({ crossingAngle: 55, crossingFrom: 0.4 });
const handBack = handWith({ crossingAngle: -50, crossingFrom: 0.3, clustering: 0 });
/** Strokes beside each other, in two lanes of a row. */
const handBeside = handWith({ overlap: 0.35, crossingAngle: 70, crossingFrom: 0.5 });
const handAlone = handWith({ crossingAngle: 0, length: 4, clustering: 0.9 });

const formCases: readonly EngravedCase[] = [
  { name: 'along the form' },
  { name: 'along the form, a ruling machine', lines: { irregularity: 0 } },
  { name: 'across the form', lines: { direction: 'acrossForm' } },
  { name: 'along the form, crossing from light tones on', lines: { crossFrom: 0.2 } },
  { name: 'along the form, somewhat wider apart than the lines that were baked', lines: { lineSpacing: 40 } },
  { name: 'across the form, wider apart than lines may lie', lines: { direction: 'acrossForm', lineSpacing: 150 } },
  { name: 'along the form, wider apart than lines may lie', lines: { lineSpacing: 150 } },
  { name: 'along the form, finer than lines may lie', lines: { lineSpacing: 2.6 } },
  { name: 'along the form, sized on the object', screenSpaceShare: 0, lines: { lineSpacing: 12 } },
  { name: 'along the form of a rotated, moved and scaled object', matrixWorld: placed },
  { name: 'along the form of a mirrored object', matrixWorld: mirrored },
  { name: 'along the form of an object scaled unequally', matrixWorld: squashed },
  { name: 'along the form of a geometry off its origin', mesh: moved(torus, 3), matrixWorld: movedBack(3) },
  { name: 'along the form, orthographic camera', isOrthographic: true },
  { name: 'along the form, with a pen', lines: { technique: 'pen', lineSpacing: 9 } },
  { name: 'along the form, with a hand', lines: { technique: 'pen', hand } },
  { name: 'along the form, with strokes beside each other', lines: { technique: 'pen', hand: handBeside } },
  {
    name: 'across the form, with a hand that crosses back',
    lines: { technique: 'pen', hand: handBack, direction: 'acrossForm' },
  },
  {
    name: 'along the form, with a hand, sized on the object',
    screenSpaceShare: 0,
    lines: { technique: 'pen', hand: handAlone },
  },
  { name: 'along the form, carved', lines: { technique: 'woodcut', crossFrom: 1, lineSpacing: 9 } },
  ...(['tone', 'cross', 'reorient'] as const).map((shadowStrokes) => ({
    name: `along the form, in shadow, ${shadowStrokes}`,
    lights: [blocked, ambient],
    material: { shadowStrokes },
  })),
];

const cases: EngravedCase[] = [
  ...formCases.map((one) => ({ ...one, lines: { direction: 'form' as const, form, ...one.lines } })),
  { name: 'tangent to the light' },
  { name: 'tangent to the light, a ruling machine', lines: { irregularity: 0 } },
  { name: 'towards the light', lines: { direction: 'towardsLight' } },
  { name: 'towards the light, a ruling machine', lines: { direction: 'towardsLight', irregularity: 0 } },
  { name: 'tangent to a light from above', lights: [fromAbove] },
  ...(['x', 'y', 'z'] as const).map((direction) => ({
    name: `across the axis ${direction}`,
    lines: { direction, irregularity: direction === 'x' ? 0 : 0.4 },
  })),
  { name: 'a very unsteady hand', lines: { irregularity: 1 } },
  { name: 'with a pen', lines: { technique: 'pen', lineSpacing: 9 } },
  {
    name: 'with a pen, aslant, crossing from light tones on',
    matrixWorld: placed,
    lines: { technique: 'pen', direction: 'slant', crossFrom: 0.2, lineSpacing: 7 },
  },
  { name: 'with strokes beside each other, aslant', lines: { technique: 'pen', hand: handBeside, direction: 'slant' } },
  { name: 'with a hand', matrixWorld: placed, lines: { technique: 'pen', hand } },
  { name: 'with a hand that crosses back, aslant', lines: { technique: 'pen', hand: handBack, direction: 'slant' } },
  {
    name: 'with a hand, towards a near lamp, crossed by shadow',
    lights: [lamp, blocked],
    lines: { technique: 'pen', hand: handAlone, direction: 'towardsLight' },
    material: { shadowStrokes: 'cross' },
  },
  { name: 'across a slant', lines: { direction: 'slant' } },
  { name: 'carved', lines: { technique: 'woodcut', crossFrom: 1, lineSpacing: 9 } },
  {
    name: 'carved towards a near lamp',
    lights: [lamp],
    lines: { technique: 'woodcut', direction: 'towardsLight', crossFrom: 1 },
  },
  {
    name: 'carved across the axis y, sized on the object',
    screenSpaceShare: 0,
    lines: { technique: 'woodcut', direction: 'y' },
  },
  {
    name: 'carved, placed and crossed by shadow',
    lights: [blocked, ambient],
    matrixWorld: placed,
    lines: { technique: 'woodcut' },
    material: { shadowStrokes: 'cross' },
  },
  { name: 'no crossing', lines: { crossFrom: 1 } },
  { name: 'crossing at right angles from light tones on', lines: { crossFrom: 0.2, crossAngle: Math.PI / 2 } },
  { name: 'finer than lines may lie', lines: { lineSpacing: 2.6 } },
  { name: 'wide apart', lines: { lineSpacing: 21 } },
  { name: 'sized on the object', screenSpaceShare: 0, lines: { lineSpacing: 12 } },
  { name: 'sized half on the screen', screenSpaceShare: 0.5 },
  { name: 'rotated object', matrixWorld: rotated },
  { name: 'rotated, moved and scaled object', matrixWorld: placed },
  { name: 'mirrored object', matrixWorld: mirrored },
  { name: 'object scaled unequally', matrixWorld: squashed },
  { name: 'geometry off its origin', mesh: moved(torus, 3), matrixWorld: movedBack(3) },
  { name: 'orthographic camera', isOrthographic: true },
  { name: 'seen at a slant', mesh: wall, matrixWorld: leaning },
  { name: 'seen at a slant by an orthographic camera', mesh: wall, matrixWorld: leaning, isOrthographic: true },
  { name: 'two lights', lights: [directional, redSide] },
  { name: 'two lights as strong as each other, rotated object', lights: crossed, matrixWorld: rotated },
  { name: 'no light with a direction', lights: [hemisphere] },
  { name: 'a near lamp', lights: [lamp] },
  { name: 'a near lamp, rotated, moved and scaled object', lights: [lamp], matrixWorld: placed },
  { name: 'turned from the light', material: { strokeAngle: 0.7 } },
  {
    name: 'turned from the direction to the light',
    material: { strokeAngle: 0.4 },
    lines: { direction: 'towardsLight' },
  },
  { name: 'turned from a near lamp', lights: [lamp], material: { strokeAngle: -0.6 } },
  { name: 'turned beyond a near lamp', lights: [lamp], material: { strokeAngle: 2.2 } },
  { name: 'towards a near lamp', lights: [lamp], lines: { direction: 'towardsLight' } },
  { name: 'a lamp, a spot and a light without an end', lights: [lamp, redSide, spot] },
  { name: 'exposed, perceptual tone', lights: [redSide, spot], material: { exposure: 2.2, toneCurve: 'perceptual' } },
  { name: 'perceptual tone, reflected light', material: { toneCurve: 'perceptual', reflectedLight: 0.4 } },
  {
    name: 'reflected light on a plane wall, beside the light',
    mesh: wall,
    matrixWorld: leaning,
    lights: [lamp, redSide],
    material: { reflectedLight: 0.8 },
  },
  {
    name: 'local tone, of light ink on dark paper',
    material: {
      ...{ color: [0.3, 0.12, 0.5], colorHatching: 0.8, colorFill: 0, reflectedLight: 0.4 },
      toneCurve: [
        [0, 0.95],
        [0.6, 0.3],
        [1, 0.05],
      ],
    },
  },
  ...(['tone', 'cross', 'reorient'] as const).flatMap((shadowStrokes) => [
    { name: `in shadow, ${shadowStrokes}`, lights: [blocked, ambient], material: { shadowStrokes } },
    {
      name: `in the shadow of one of three lights, ${shadowStrokes}, moved object`,
      lights: [lamp, blocked, redSide],
      matrixWorld: placed,
      material: { shadowStrokes },
    },
  ]),
  { name: 'in focus at a point, falling off around it', material: { focus: [0.3, 0.4, 0.2], focusRadius: 0.4 } },
  {
    name: 'on a plane that falls off around a point',
    mesh: wall,
    matrixWorld: leaning,
    material: { focus: [0.2, 0.1, 0.3], focusRadius: 0.5 },
  },
  { name: 'falling off towards the rim', material: { vignette: 0.9 } },
  { name: 'of less importance', importance: 0.4 },
  { name: 'fading with its depth', material: { depthFade: 0.8, depthFadeStart: 2.4, depthFadeEnd: 4.1 } },
  {
    name: 'fading with its depth, seen at a slant by an orthographic camera',
    mesh: wall,
    matrixWorld: leaning,
    isOrthographic: true,
    material: { depthFade: 1, depthFadeStart: 2, depthFadeEnd: 4.5 },
  },
  {
    name: 'crossed by shadow, fading',
    lights: [blocked, ambient],
    material: { shadowStrokes: 'cross', depthFade: 0.6, depthFadeStart: 2, depthFadeEnd: 4 },
  },
  { name: 'out of all shadows, cross', lights: [directional, redSide], material: { shadowStrokes: 'cross' } },
];

/** The page's input for a case. */
const specFor = ({ lines, ...rest }: EngravedCase): HatchingSpec => ({
  ...specOf(rest, 'engraving'),
  lines: {
    direction: 'light',
    lineSpacing: 7,
    strokeLength: 72,
    crossFrom: 0.52,
    crossAngle: Math.PI / 3,
    irregularity: 0.4,
    ...lines,
  },
});

/** The page's input for all cases of `engraving` without hands, whose strokes only WebGLRenderer draws, by name. */
export const engravingSpecs = (): Map<string, HatchingSpec> =>
  new Map(cases.filter(({ lines }) => !lines?.hand).map((one) => [one.name, specFor(one)]));

/** Names of cases that together have each light, layer, field, placement and look. */
const detailsOf = quickOnly(
  cases.map(({ name }) => name),
  [
    'along the form',
    'across the form, wider apart than lines may lie',
    'along the form, in shadow, cross',
    'tangent to the light',
    'towards the light, a ruling machine',
    'across the axis y',
    'along the form, with a pen',
    'across the form, with a hand that crosses back',
    'with a hand',
    'carved, placed and crossed by shadow',
    'sized on the object',
    'object scaled unequally',
    'seen at a slant by an orthographic camera',
    'turned from a near lamp',
    'a lamp, a spot and a light without an end',
    'in the shadow of one of three lights, reorient, moved object',
    'local tone, of light ink on dark paper',
    'on a plane that falls off around a point',
    'falling off towards the rim',
    'fading with its depth, seen at a slant by an orthographic camera',
  ],
);

/**
 * Declares a test for each case of `engraving`: the page draws what the functions of vector files say.
 *
 * @param test whose page has `renderHatching`
 */
export function compareEngraving(test: TestOnOnePage): void {
  for (const one of cases) {
    test(`engraving equals the lines of vector files: ${one.name}`, detailsOf(one.name), async ({ page }) => {
      const spec = specFor(one);
      const reference = referenceOf(spec);
      const scene = {
        ...spec,
        lines: spec.lines!,
        screenSpaceShare: spec.screenSpaceShare!,
        centre: centreOf(spec.positions),
      };
      await expectDarkness(page, spec, reference, engravingDarkness(scene, reference));
    });
  }
}
