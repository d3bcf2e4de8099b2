import { needsMap } from 'three-hatching/facts';
import { type DrawSVGOptions, drawSVG, plottingTime, type SVGDrawing } from 'three-hatching/svg';
import { materialLook } from '../../viewer/settings/materialLook.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { drawPicture, type PrintPlan, planSvg, printablePlan } from '../print/print.js';
import type { PictureSession } from '../viewport/PictureSession.js';
import type { SaveDrawing } from './download.js';
import { download } from './download.js';
import { drawCovered } from './drawCovered.js';

/** The share of the progress for drawing the raster picture below the lines. */
const PICTURE = 0.5;

/** How strokes appear in the file: as lines, in the raster picture below, or not at all. */
type Strokes = 'lines' | 'picture' | 'nowhere';

/** A drawing of lines that is not saved yet. */
export interface LineFile {
  drawing: SVGDrawing;
  /** Without extension. */
  name: string;
  /** Says what the file is and how it differs from the page. */
  sentence: string;
}

/**
 * Saves the drawing as SVG in the size of the settings, with fills for print or with lines for pens. Strokes from a tonal art map are
 * not lines: in print they are a raster picture below the lines.
 */
export const saveSvg: SaveDrawing = async (...what) => downloadLines(await drawLineFile(...what));

/** Downloads a drawing of lines as SVG, and returns its sentence. */
export function downloadLines({ drawing: { svg }, name, sentence }: LineFile): string {
  download(new Blob([svg], { type: 'image/svg+xml' }), `${name}.svg`);
  return sentence;
}

/** Draws the lines that {@link saveSvg} saves. */
export const drawLineFile: SaveDrawing<LineFile> = (viewport, settings, name, report, signal) =>
  drawCovered(viewport, settings, signal, async (session, plan) => {
    const { sheet, margin, within } = planSvg(settings, plan);
    const isPen = settings.pictureSvg === 'pen';
    const strokes = strokesOf(settings);
    const [from, printed] = strokes === 'picture' ? [PICTURE, printablePlan(within, plan.dpi)] : [0, undefined];
    const onDrawn = (progress: number): void => report('drawing the strokes', from * progress);
    const picture = printed && (await dataUrlOf(await drawStrokes(session, settings, printed, onDrawn, signal)));
    session.restoreScene();
    const camera = viewport.camera.clone();
    camera.setViewOffset(within.viewWidth, within.viewHeight, within.left, within.top, within.width, within.height);
    const drawing = await drawSVG(viewport.scenery.scene, camera, {
      kind: settings.pictureSvg,
      ...(isPen && {
        penWidth: settings.picturePen,
        pens: pensOf(settings),
        note: settings.pictureNote === 'pens' && name,
      }),
      // A plotter would draw the border of the paper.
      ...(!isPen && settings.pictureGround === 'paper' && { paper: settings.paper }),
      ...{ sheet, margin, picture, signal },
      dpi: within.dpi / within.scale,
      onProgress: (progress) => report('drawing the lines', from + (1 - from) * progress),
    });
    const remarks = remarksOn(drawing, settings, strokes);
    if (drawing.paths === 0 && !picture)
      throw new Error([strokes === 'nowhere' ? NO_LINES_OF_MAPS : 'there are no lines.', ...remarks].join(' '));
    const size = `${sheet.map(Math.round).join(' × ')} mm, ${drawing.paths.toLocaleString('en')} paths`;
    const saved = `Saved as SVG${SAVED[strokes]}: ${size}${printed ? `, ${Math.round(printed.dpi)} dpi` : ''}${plotting(drawing)}.`;
    return { drawing, name, sentence: [saved, ...remarks].join(' ') };
  });

/** What has a layer of its own, or the pens of the user with their widths. Of pens of one colour the first counts. */
function pensOf({ picturePens, ...settings }: Settings): DrawSVGOptions['pens'] {
  if (picturePens !== 'two' && picturePens !== 'three') return picturePens;
  const pens = [
    { color: settings.picturePenA, width: settings.picturePenWidthA },
    { color: settings.picturePenB, width: settings.picturePenWidthB },
    { color: settings.picturePenC, width: settings.picturePenWidthC },
  ].slice(0, picturePens === 'two' ? 2 : 3);
  return pens.filter(({ color }, i) => pens.findIndex((pen) => pen.color === color) === i);
}

/** How long the lines of a pen are, and how long an AxiDraw takes for them. */
function plotting({ drawn, plotSeconds }: SVGDrawing): string {
  if (plotSeconds === null) return '';
  return `, ${(drawn / 1000).toFixed(1)} m of line, ${plottingTime(plotSeconds)} on an AxiDraw`;
}

const NO_LINES_OF_MAPS = 'there are no lines: the strokes come from a map, which a pen cannot draw.';

/** Sentences about the strokes. They come first, because the status line is short. */
const SAVED: Readonly<Record<Strokes, string>> = {
  lines: '',
  picture: ', its strokes as a picture',
  nowhere: ' without its strokes, which a pen cannot draw',
};

/** How the strokes of a look are saved: those of a map are images, which a plotter cannot draw. */
function strokesOf(settings: Settings): Strokes {
  if (!needsMap(materialLook(settings))) return 'lines';
  return settings.pictureSvg === 'pen' ? 'nowhere' : 'picture';
}

/** Draws the strokes of the canvas, without those saved as lines, on the background of saved pictures. */
const drawStrokes = (
  session: PictureSession,
  { pictureGround: ground }: Settings,
  plan: PrintPlan,
  onProgress: (progress: number) => void,
  signal: AbortSignal,
): Promise<Blob> => drawPicture(session, plan, { ground, isUnderLines: true }, { signal, onProgress });

function dataUrlOf(picture: Blob): Promise<string> {
  const reader = new FileReader();
  return new Promise((resolve, reject) => {
    reader.onload = () => resolve(reader.result as string);
    reader.onerror = () => reject(new Error('the picture of the strokes is too large for this browser.'));
    reader.readAsDataURL(picture);
  });
}

/** Sentences on how the file differs from the page. */
function remarksOn({ leftOut }: SVGDrawing, { compare }: Settings, strokes: Strokes): string[] {
  const remarks: string[] = [];
  if (compare !== 'none') remarks.push('It shows one technique, without the comparison.');
  // The reasons of meshes concern strokes, which are covered above.
  const reasons = leftOut
    .filter(({ object }) => strokes === 'lines' || !('isMesh' in object))
    .map(({ reason }) => reason);
  if (reasons.length > 0) remarks.push(reasons[0]);
  if (reasons.length > 1) remarks.push(`So it is with ${reasons.length - 1} more.`);
  return remarks;
}
