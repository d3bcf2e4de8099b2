import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { counted } from '../../viewer/files/common/counted.js';
import { lightsOfFile } from '../../viewer/sceneSetup/lightsOfFile.js';
import { viewsOfFile } from '../../viewer/sceneSetup/viewsOfFile.js';
import { isLitBy, lightOf, type SavedView } from '../../viewer/settings/savedViews.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { extrasInWorld } from '../maps/extrasInWorld.js';
import type { Viewport } from '../viewport/Viewport.js';
import type { lightModel } from './lightModel.js';

/** Lights models, and makes views of the cameras and the lights of their files. */
export class FileViews {
  /** The lights of the shown model's file, if it is lit by these: those before it, its own, and the light that suits its view. */
  private lit: Record<'before' | 'given' | 'found', SavedView['light']> | undefined;

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
  ) {}

  /** Lights the shown model. The lights of the file before it were those of its model alone. */
  light(light: typeof lightModel): void {
    const { settings, viewport, lit } = this;
    if (lit && isLitBy(settings, lit.given)) Object.assign(settings, lit.before);
    const before = lightOf(settings);
    const found = light(viewport, settings);
    this.lit = found && { before, given: lightOf(settings), found };
  }

  /** The views of the file of the model that was lit last, and notes on cameras and lights that are left out. */
  of(model: HatchedModel): { views: SavedView[]; notes: string[] } {
    const { cameras, lights } = extrasInWorld(model);
    const { views, leftOut } = viewsOfFile(cameras, lightOf(this.settings), this.lit?.found);
    const dark = this.lit ? (lightsOfFile(lights)?.leftOut ?? 0) : 0;
    const notes = [counted(leftOut, 'camera', 'left out'), counted(dark, 'light', 'left out')];
    return { views, notes: notes.filter(Boolean) };
  }
}
