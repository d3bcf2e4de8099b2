import { describe, expect, test } from 'vitest';
import {
  coarsePlan,
  cutPlan,
  millimetresPerPixel,
  PAPER_FORMATS,
  planPrint,
  type Size,
  sheetOnView,
  strokeScale,
  toMillimetres,
} from '../../../../src/playground/print/printPlan.js';
import { strokeShare } from '../../../../src/viewer/sceneSetup/framing.js';
import { defaultSettings, SETTINGS, type Settings } from '../../../../src/viewer/settings/settings.js';

const settings = (changes: Partial<Settings>): Settings => ({ ...defaultSettings(), ...changes });
const wide = { width: 900, height: 500, isWide: true };
const upright = { width: 380, height: 700, isWide: false };

describe('planPrint', () => {
  test.each(Object.entries(PAPER_FORMATS))(
    'measures %s to a pixel, turned as suits the model',
    (format, [short, long]) => {
      for (const pictureDpi of Object.keys(SETTINGS.pictureDpi.choices) as Settings['pictureDpi'][]) {
        for (const view of [wide, upright]) {
          const asked = settings({ pictureSize: format as 'a4', pictureDpi });
          const plan = planPrint(asked, view);
          const [width, height] = view === wide ? [long, short] : [short, long];
          const pixel = 25.4 / Number(pictureDpi);
          expect(Math.abs(toMillimetres(plan.width, plan.dpi) - width)).toBeLessThanOrEqual(pixel / 2);
          expect(Math.abs(toMillimetres(plan.height, plan.dpi) - height)).toBeLessThanOrEqual(pixel / 2);
          // What lies under the frame on the page is on the sheet, and nothing else.
          const [across, down] = sheetOnView(asked, view)!;
          expect(plan.width / plan.viewWidth).toBeCloseTo(across, 2);
          expect(plan.height / plan.viewHeight).toBeCloseTo(down, 2);
          expect(plan.viewWidth / plan.viewHeight).toBeCloseTo(view.width / view.height, 6);
          expect(Math.abs(2 * plan.left - (plan.viewWidth - plan.width))).toBeLessThanOrEqual(1);
          expect(Math.abs(2 * plan.top - (plan.viewHeight - plan.height))).toBeLessThanOrEqual(1);
          const [shown, own] = [strokeShare(plan.viewWidth, plan.viewHeight), strokeShare(view.width, view.height)];
          expect(plan.scale).toBeCloseTo(Math.max(plan.viewWidth / view.width, shown / own), 6);
        }
      }
    },
  );

  test('turns a sheet as it is told, and has it in the middle of the view, as large as a margin lets it', () => {
    for (const view of [wide, upright]) {
      for (const pictureTurn of ['portrait', 'landscape'] as const) {
        const [across, down] = sheetOnView(settings({ pictureSize: 'a5', pictureTurn }), view)!;
        const [width, height] = [across * view.width, down * view.height];
        expect(width / height).toBeCloseTo(pictureTurn === 'portrait' ? 148 / 210 : 210 / 148, 6);
        expect(Math.min(view.width - width, view.height - height)).toBeCloseTo(24, 6);
      }
      const own = settings({ pictureSize: 'own', pictureWidth: 300, pictureHeight: 100, pictureTurn: 'portrait' });
      const [across, down] = sheetOnView(own, view)!;
      expect((across * view.width) / (down * view.height)).toBeCloseTo(3, 6);
      expect(sheetOnView(settings({ pictureSize: '2' }), view)).toBeUndefined();
    }
  });

  test('takes a size of one’s own as it is, and that of the page by pixels', () => {
    const own = planPrint(
      settings({ pictureSize: 'own', pictureWidth: 120, pictureHeight: 80, pictureDpi: '300' }),
      upright,
    );
    expect([own.width, own.height]).toEqual([1417, 945]);
    const twice = planPrint(settings({ pictureSize: '2' }), wide);
    expect(twice).toMatchObject({ width: 1800, height: 1000, viewWidth: 1800, left: 0, top: 0, scale: 2, dpi: 300 });
    expect(millimetresPerPixel(settings({ pictureSize: '2' }), wide)).toBeCloseTo((2 * 25.4) / 300, 6);
    expect(millimetresPerPixel(settings({ pictureSize: 'a4', pictureDpi: '1200' }), wide)).toBeCloseTo(
      210 / (500 - 24),
      3,
    );
  });

  test('has strokes as wide as on the page, in proportion, and no finer than on a screen of as many pixels', () => {
    const scaleOf = (dpi: Settings['pictureDpi'], view: Size) =>
      planPrint(settings({ pictureSize: 'own', pictureWidth: 200, pictureHeight: 120, pictureDpi: dpi }), {
        ...view,
        isWide: true,
      }).scale;
    const large = { width: 2000, height: 1200 };
    expect(scaleOf('600', large)).toBeCloseTo(4724 / 1960, 6);
    expect(scaleOf('150', large)).toBe(1);
    // A smaller sheet has finer strokes on the screen, too; but this picture is no smaller than large sheets.
    const small = { width: 400, height: 240 };
    const share = strokeShare(small.width, small.height);
    expect(scaleOf('600', small)).toBeCloseTo(4724 / 360, 6);
    expect(scaleOf('150', small) * share).toBeCloseTo((1181 / 360) * share, 6);
    expect(strokeScale(1.2, { width: 1280, height: 720 }, small) * share).toBeCloseTo(1, 6);
  });

  test('is cut to the drawing, and looked at in coarse, without moving it', () => {
    const plan = planPrint(settings({ pictureSize: 'a6', pictureDpi: '150' }), wide);
    const cut = cutPlan(plan, { left: 0.25, top: 0.5, right: 0.5, bottom: 2 });
    expect([cut.width, cut.height]).toEqual([219, 310]);
    expect([cut.left - plan.left, cut.top - plan.top]).toEqual([218, 310]);
    // Pixels that are drawn together are those of the whole.
    for (const odd of [0.2511, 0.3527, 0.4517]) {
      const other = cutPlan(plan, { left: odd, top: odd, right: 0.9, bottom: 0.5 + odd });
      expect((other.left - plan.left) % 2).toBe(0);
      expect((plan.height - (other.top - plan.top) - other.height) % 2).toBe(0);
    }
    expect([cut.viewWidth, cut.scale]).toEqual([plan.viewWidth, plan.scale]);
    const coarse = coarsePlan(plan, 437);
    expect(coarse.width).toBe(437);
    for (const key of ['viewWidth', 'left', 'top', 'scale'] as const) expect(coarse[key]).toBeCloseTo(plan[key] / 2, 9);
  });
});
