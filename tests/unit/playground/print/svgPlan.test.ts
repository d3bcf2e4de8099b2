import { describe, expect, test } from 'vitest';
import { planSvg, printablePlan } from '../../../../src/playground/print/print.js';
import { cutPlan, planPrint, toMillimetres } from '../../../../src/playground/print/printPlan.js';
import { defaultSettings, type Settings } from '../../../../src/viewer/settings/settings.js';

const view = { width: 900, height: 500, isWide: true };
const plans = (changes: Partial<Settings>) => {
  const settings = { ...defaultSettings(), ...changes };
  const plan = planPrint(settings, view);
  return { plan, svg: planSvg(settings, plan) };
};

describe('planSvg', () => {
  test('a drawing in the size of the page has no margin, and CSS pixels of it', () => {
    const { plan, svg } = plans({ pictureSize: '1', pictureMargin: 25 });
    expect(svg.margin).toBe(0);
    expect(svg.sheet).toEqual([238.1, 132.3]);
    expect(svg.within).toEqual({ ...plan, dpi: expect.closeTo(96, 9) });
    const twice = plans({ pictureSize: '2' }).svg;
    expect(twice.sheet).toEqual([476.3, 264.6]);
    expect(twice.within.dpi / twice.within.scale).toBeCloseTo(48, 9);
  });

  test.each(['a6', 'a4'] as const)('within the margins of %s lies all that its sheet shows, smaller', (pictureSize) => {
    const { svg: bare } = plans({ pictureSize, pictureMargin: 0 });
    const { plan, svg } = plans({ pictureSize, pictureMargin: 12 });
    expect(svg.sheet).toEqual(bare.sheet);
    expect(bare.within).toEqual({ ...plan, dpi: expect.closeTo(300, 0) });
    const { within } = svg;
    // It fills the room between the margins, both ways.
    for (const [i, pixels] of [within.width, within.height].entries())
      expect(toMillimetres(pixels, within.dpi)).toBeCloseTo(svg.sheet[i] - 24, 0);
    // Nothing of the sheet is cut off, and its middle stays where it is.
    expect(within.width).toBeGreaterThanOrEqual(plan.width);
    expect(within.height).toBeGreaterThanOrEqual(plan.height);
    expect(Math.min(within.width / plan.width, within.height / plan.height)).toBe(1);
    expect(within.left + within.width / 2).toBeCloseTo(plan.left + plan.width / 2, 6);
    expect(within.top + within.height / 2).toBeCloseTo(plan.top + plan.height / 2, 6);
    // Strokes become smaller with the picture.
    expect(within.scale).toBe(plan.scale);
    expect(within.dpi).toBeGreaterThan(plan.dpi);
  });

  test.each(['150', '300', '1200'] as const)('a sheet is as large as it is named, also at %s dpi', (pictureDpi) => {
    expect(plans({ pictureSize: 'a5', pictureDpi }).svg.sheet).toEqual([210, 148]);
    const own = { pictureSize: 'own', pictureWidth: 121, pictureHeight: 83 } as const;
    expect(plans({ ...own, pictureDpi }).svg.sheet).toEqual([121, 83]);
    expect(plans({ pictureSize: 'letter', pictureDpi }).svg.sheet).toEqual([279.4, 215.9]);
    const inches = { pictureSize: 'inches', pictureWidthInches: 9.5, pictureHeightInches: 12 } as const;
    for (const [i, side] of plans({ ...inches, pictureDpi }).svg.sheet.entries())
      expect(side).toBeCloseTo([241.3, 304.8][i], 9);
  });

  test('what is cut to the drawing has no margin', () => {
    const settings = { ...defaultSettings(), pictureSize: 'a5', pictureCrop: 'drawing' } as const;
    const cut = cutPlan(planPrint(settings, view), { left: 0.2, top: 0.2, right: 0.8, bottom: 0.7 });
    expect(planSvg(settings, cut).margin).toBe(0);
  });

  test('margins that leave no room are refused in a sentence', () => {
    const own = { pictureSize: 'own', pictureWidth: 60, pictureHeight: 40 } as const;
    expect(() => plans({ ...own, pictureMargin: 20 })).toThrow(
      'margins of 20 mm leave no room on a sheet of 60 × 40 mm. Make them smaller.',
    );
    expect(plans({ ...own, pictureMargin: 19 }).svg.margin).toBe(19);
  });
});

describe('printablePlan', () => {
  test('is as fine as a print, and shows the same', () => {
    const { plan, svg } = plans({ pictureSize: '1' });
    const printed = printablePlan(svg.within, plan.dpi);
    expect([printed.width, printed.height]).toEqual([2813, 1563]);
    expect(printed.dpi).toBeCloseTo(300, 0);
    expect(printed.viewWidth / printed.width).toBe(plan.viewWidth / plan.width);
    expect(printed.scale / printed.width).toBeCloseTo(plan.scale / plan.width, 6);
  });

  test('is no larger than a file can hold', () => {
    const { plan, svg } = plans({ pictureSize: 'a2', pictureDpi: '1200', pictureMargin: 0 });
    const printed = printablePlan(svg.within, plan.dpi);
    expect(printed.width * printed.height).toBeLessThan(36_100_000);
    expect(printed.dpi).toBeGreaterThan(300);
    expect(printed.left / printed.width).toBeCloseTo(plan.left / plan.width, 9);
  });
});
