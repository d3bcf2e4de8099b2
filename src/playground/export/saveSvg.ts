import { needsMap } from 'three-hatching/facts';
import { drawSVG, type SVGDrawing } from 'three-hatching/svg';
import { materialLook } from '../../viewer/settings/materialLook.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { drawPicture, type PrintPlan, planSvg, printablePlan } from '../print/print.js';
import type { PictureSession } from '../viewport/PictureSession.js';
import { behindCurtain } from './behindCurtain.js';
import { download } from './download.js';
import type { SaveDrawing } from './SaveDrawing.js';

/** The share of the progress in which the picture below the lines is drawn. */
const PICTURE = 0.5;

/** Where the strokes of a saved drawing are. */
type Strokes = 'lines' | 'picture' | 'nowhere';

/**
 * Saves the drawing as lines: an SVG file of the size that the settings ask for, filled for print or for one pen. Strokes that come from a
 * map are no lines: in a print they lie below the others as a picture.
 */
export const saveSvg: SaveDrawing = (viewport, settings, name, report, signal) =>
  behindCurtain(viewport, settings, signal, async (session, plan) => {
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
      ...(isPen && { penWidth: settings.picturePen }),
      // A pen would draw the border of the paper.
      ...(!isPen && settings.pictureGround === 'paper' && { paper: settings.paper }),
      ...{ sheet, margin, picture, signal },
      dpi: within.dpi / within.scale,
      onProgress: (progress) => report('drawing the lines', from + (1 - from) * progress),
    });
    const remarks = remarksOn(drawing, settings, strokes);
    if (drawing.paths === 0 && !picture)
      throw new Error([strokes === 'nowhere' ? NO_LINES_OF_MAPS : 'there are no lines.', ...remarks].join(' '));
    download(new Blob([drawing.svg], { type: 'image/svg+xml' }), `${name}.svg`);
    const size = `${sheet.map(Math.round).join(' × ')} mm, ${drawing.paths.toLocaleString('en')} paths`;
    return [
      `Saved as SVG${SAVED[strokes]}: ${size}${printed ? `, ${Math.round(printed.dpi)} dpi` : ''}.`,
      ...remarks,
    ].join(' ');
  });

const NO_LINES_OF_MAPS = 'there are no lines: the strokes come from a map, which a pen cannot draw.';

/** What is said of strokes first, as lines of the status are short. */
const SAVED: Readonly<Record<Strokes, string>> = {
  lines: '',
  picture: ', its strokes as a picture',
  nowhere: ' without its strokes, which a pen cannot draw',
};

/** Where the strokes of a look leave: those of a map are images, which a pen does not draw. */
function strokesOf(settings: Settings): Strokes {
  if (!needsMap(materialLook(settings))) return 'lines';
  return settings.pictureSvg === 'pen' ? 'nowhere' : 'picture';
}

/** The strokes of the canvas without what is drawn as lines over them, on the ground of saved pictures. */
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

/** What the file shows otherwise than the page does. */
function remarksOn({ leftOut }: SVGDrawing, { compare }: Settings, strokes: Strokes): string[] {
  const remarks: string[] = [];
  if (compare !== 'none') remarks.push('It shows one technique, without the comparison.');
  // The reasons of meshes are those of strokes, which were named above.
  const reasons = leftOut
    .filter(({ object }) => strokes === 'lines' || !('isMesh' in object))
    .map(({ reason }) => reason);
  if (reasons.length > 0) remarks.push(reasons[0]);
  if (reasons.length > 1) remarks.push(`So it is with ${reasons.length - 1} more.`);
  return remarks;
}
