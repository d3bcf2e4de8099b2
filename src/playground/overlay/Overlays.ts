import { page } from '../elements/page.js';
import type { Session } from '../session/Session.js';
import type { LaterPart, LaterParts } from '../tasks/LaterParts.js';
import { Comparison } from './Comparison.js';
import type { LightHandles } from './LightHandles.js';
import type { SheetFrame } from './SheetFrame.js';
import { TurnHint } from './TurnHint.js';

/**
 * What lies over the drawing: the handles of the lights, the divider of a comparison, the frame of a sheet, and the hint that a model is
 * the wrong way up.
 */
export class Overlays {
  private readonly lights: LaterPart<LightHandles>;
  private readonly sheetFrame: LaterPart<SheetFrame>;

  constructor(session: Session, parts: LaterParts) {
    const { stage, settings } = session;
    this.lights = parts.later(async () => {
      const { LightHandles } = await import('./LightHandles.js');
      return new LightHandles(stage, settings, (source) => session.recordChange(source));
    });
    this.sheetFrame = parts.later(async () => {
      const { SheetFrame } = await import('./SheetFrame.js');
      return new SheetFrame(stage, settings);
    });
    const comparison = new Comparison(stage, settings, parts);
    const turnHint = new TurnHint(page.turnHint, settings, () => session.recordChange());
    session.listen({
      applied: () => {
        comparison.refresh();
        turnHint.refresh();
        this.sheetFrame.present?.refresh();
      },
      modelShown: () => turnHint.about(settings.model === 'file' ? stage.model?.stands : undefined),
    });
    const follow = (): void => {
      this.lights.present?.update();
      comparison.place();
    };
    stage.frames.onFrame(follow);
    stage.frames.onWait(follow);
    this.lights.use(() => stage.frames.invalidate());
  }

  /** Whether the lights have their handles. */
  get hasLights(): boolean {
    return this.lights.present !== undefined;
  }

  /** Shows or hides the frame of the sheet on which a picture will be saved. It is seen only if the settings ask for a sheet. */
  showSheet(isShown: boolean): void {
    this.sheetFrame.use((frame) => frame.show(isShown));
  }
}
