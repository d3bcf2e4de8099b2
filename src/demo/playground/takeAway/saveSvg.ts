import { drawSVG, type SVGDrawing } from 'three-hatching/svg';
import type { Settings } from '../../../settings/settings.js';
import { type PrintPlan, toMillimetres } from '../../print/printPlan.js';
import { behindCurtain } from './behindCurtain.js';
import { download } from './download.js';
import type { SaveDrawing } from './SaveDrawing.js';

/** CSS pixels to an inch, by which a drawing in the size of the page is measured. */
const CSS_DPI = 96;

/** Saves the drawing as lines: an SVG file of the size that the settings ask for, filled for print or for one pen. */
export const saveSvg: SaveDrawing = (stage, settings, name, report, signal) =>
  behindCurtain(stage, settings, signal, async (_session, plan) => {
    const dpi = dpiOf(settings, plan);
    // A sheet is a whole number of pixels, and so up to half of one smaller or larger.
    const [width, height] = [plan.width, plan.height].map((pixels) => Math.round(10 * toMillimetres(pixels, dpi)) / 10);
    const camera = stage.camera.clone();
    camera.setViewOffset(plan.viewWidth, plan.viewHeight, plan.left, plan.top, plan.width, plan.height);
    const isPen = settings.pictureSvg === 'pen';
    const drawing = await drawSVG(stage.scenery.scene, camera, {
      kind: settings.pictureSvg,
      ...(isPen && { penWidth: settings.picturePen }),
      // A pen would draw the border of the paper.
      ...(!isPen && settings.pictureGround === 'paper' && { paper: settings.paper }),
      sheet: [width, height],
      margin: 0,
      dpi: dpi / plan.scale,
      signal,
      onProgress: (progress) => report('drawing the lines', progress),
    });
    if (drawing.paths === 0) throw new Error(`there are no lines. ${missingFrom(drawing)}`.trim());
    download(new Blob([drawing.svg], { type: 'image/svg+xml' }), `${name}.svg`);
    const size = [width, height].map(Math.round).join(' × ');
    return `Saved as SVG: ${size} mm, ${drawing.paths.toLocaleString('en')} paths. ${missingFrom(drawing)}`.trim();
  });

/** Pixels of the picture to an inch: of a sheet, or as browsers count those of a page. */
const dpiOf = ({ pictureSize }: Settings, { dpi }: PrintPlan): number =>
  Number.isFinite(Number(pictureSize)) ? CSS_DPI : dpi;

/** What the file does not show as the page does: the first reason, and how many more there are. */
function missingFrom({ leftOut }: SVGDrawing): string {
  if (leftOut.length === 0) return '';
  const [{ reason }] = leftOut;
  return leftOut.length === 1 ? reason : `${reason} So it is with ${leftOut.length - 1} more.`;
}
