import { quickOnly } from '../browser/quickIf.js';
import type { TestOnOnePage } from '../browser/test.js';
import type { HatchingSpec } from './hatchingSpec.js';
import { expectDarkness, type ReferenceCase, referenceOf, specOf } from './referenceCase.js';
import {
  ambient,
  blocked,
  directional,
  leaning,
  mirrored,
  placed,
  redSide,
  rotated,
  squashed,
  wall,
} from './referenceScenes.js';
import { stippleDarkness } from './stippleDarkness.js';

interface StippleCase extends ReferenceCase {
  dots?: Partial<NonNullable<HatchingSpec['dots']>>;
}

const cases: StippleCase[] = [
  { name: 'sized on the screen' },
  { name: 'large, with hard edges', dots: { strokeWidth: 9, edgePixels: 0 } },
  { name: 'finer than a pixel', dots: { strokeWidth: 1 } },
  { name: 'sized on the object', screenSpaceShare: 0, material: { tilesPerObjectUnit: 0.3 } },
  { name: 'sized half on the screen', screenSpaceShare: 0.5, material: { tilesPerObjectUnit: 0.3 } },
  { name: 'rotated object', matrixWorld: rotated },
  { name: 'rotated, moved and scaled object, two lights', matrixWorld: placed, lights: [directional, redSide] },
  { name: 'mirrored object', matrixWorld: mirrored },
  { name: 'object scaled unequally', matrixWorld: squashed },
  { name: 'orthographic camera', isOrthographic: true },
  { name: 'seen at a slant', mesh: wall, matrixWorld: leaning },
  { name: 'seen at a slant by an orthographic camera', mesh: wall, matrixWorld: leaning, isOrthographic: true },
  {
    name: 'falling off around a point, towards the rim and of less importance',
    importance: 0.7,
    material: { focus: [0.3, 0.4, 0.2], focusRadius: 0.5, vignette: 0.6 },
  },
  { name: 'fading with its depth', material: { depthFade: 0.8, depthFadeStart: 2.4, depthFadeEnd: 4.1 } },
  { name: 'in shadow', lights: [blocked, ambient] },
];

/** The page's input for a case. */
const specFor = ({ dots, ...rest }: StippleCase): HatchingSpec => ({
  ...specOf(rest, 'hatching'),
  dots: { strokeWidth: 3.2, edgePixels: 1, ...dots },
});

/** The page's input for all cases of `stipple`, by name. */
export const stippleSpecs = (): Map<string, HatchingSpec> => new Map(cases.map((one) => [one.name, specFor(one)]));

/** Names of cases that together have each light, layer, field, placement and look. */
const detailsOf = quickOnly(
  cases.map(({ name }) => name),
  [
    'sized on the screen',
    'rotated, moved and scaled object, two lights',
    'object scaled unequally',
    'seen at a slant by an orthographic camera',
    'falling off around a point, towards the rim and of less importance',
    'in shadow',
  ],
);

/**
 * Declares a test for each case of `stipple`: the page draws what the functions of vector files say.
 *
 * @param test whose page has `renderHatching`
 */
export function compareStipple(test: TestOnOnePage): void {
  for (const one of cases) {
    test(`stipple equals the dots of vector files: ${one.name}`, detailsOf(one.name), async ({ page }) => {
      const spec = specFor(one);
      const reference = referenceOf(spec);
      const scene = { ...spec, dots: spec.dots!, screenSpaceShare: spec.screenSpaceShare! };
      await expectDarkness(page, spec, reference, stippleDarkness(scene, reference));
    });
  }
}
