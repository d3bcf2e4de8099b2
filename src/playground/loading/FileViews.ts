import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { counted } from '../../viewer/files/common/shownText.js';
import { lightsOfFile } from '../../viewer/sceneSetup/lightsOfFile.js';
import { viewsOfFile } from '../../viewer/sceneSetup/viewsOfFile.js';
import { isLitBy, lightOf, type SavedView } from '../../viewer/settings/savedViews.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { extrasInWorld } from '../maps/extrasInWorld.js';
import type { Viewport } from '../viewport/Viewport.js';
import type { lightModel } from './lightModel.js';

/** Lights models, and creates views from the cameras and lights of their files. */
export class FileViews {
  /** If the shown model is lit by its file's lights: the previous lights, the file's, and the light that suits the view. */
  private lit: Record<'before' | 'given' | 'found', SavedView['light']> | undefined;

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
  ) {}

  /** Lights the shown model, after removing the lights of the previous file. */
  light(light: typeof lightModel): void {
    const { settings, viewport, lit } = this;
    if (lit && isLitBy(settings, lit.given)) Object.assign(settings, lit.before);
    const before = lightOf(settings);
    const found = light(viewport, settings);
    this.lit = found && { before, given: lightOf(settings), found };
  }

  /** The views of the most recently lit model's file, and notes on cameras and lights left out. */
  of(model: HatchedModel): { views: SavedView[]; notes: string[] } {
    const { cameras, lights } = extrasInWorld(model);
    const { views, leftOut } = viewsOfFile(cameras, lightOf(this.settings), this.lit?.found);
    const dark = this.lit ? (lightsOfFile(lights)?.leftOut ?? 0) : 0;
    const notes = [counted(leftOut, 'camera', 'left out'), counted(dark, 'light', 'left out')];
    return { views, notes: notes.filter(Boolean) };
  }
}
