import type { UpAxis } from '../../viewer/files/mesh/findUpAxis.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { page } from '../elements/page.js';
import type { Session } from '../session/Session.js';
import type { LaterPart, LaterParts } from '../tasks/LaterParts.js';
import type { Viewport } from '../viewport/Viewport.js';
import type { CompareDivider } from './CompareDivider.js';
import type { LightHandles } from './LightHandles.js';
import type { SheetFrame } from './SheetFrame.js';

/** Asks whether a model is the wrong way up, if its flat side suggests so, and turns it if the user agrees. */
class TurnHint {
  /** The up axis that the flat side of the model suggests. Undefined if there is none, or if the user has closed the hint. */
  private stands: UpAxis | undefined;

  /** @param onTurn called when the user has turned the model by changing the settings */
  constructor(
    private readonly elements: { hint: HTMLElement; turn: HTMLElement; leave: HTMLElement },
    private readonly settings: Settings,
    onTurn: () => void,
  ) {
    elements.turn.addEventListener('click', () => {
      if (this.stands) settings.upAxis = this.stands;
      onTurn();
    });
    elements.leave.addEventListener('click', () => this.about(undefined));
  }

  /** Takes over the suggested up axis of another model, or removes the hint. */
  about(stands: UpAxis | undefined): void {
    this.stands = stands;
    this.refresh();
  }

  refresh(): void {
    this.elements.hint.hidden = this.stands === undefined || this.stands === this.settings.upAxis;
  }
}

/** Compares two techniques side by side, with a divider between them, while the settings ask for that. */
class Comparison {
  private readonly divider: LaterPart<CompareDivider>;

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
    parts: LaterParts,
  ) {
    this.divider = parts.later(async () => {
      const { CompareDivider } = await import('./CompareDivider.js');
      return new CompareDivider(page.divider, page.viewport, () => viewport.frames.invalidate());
    });
  }

  /** To be called when the settings have changed. */
  refresh(): void {
    const { viewport, divider } = this;
    const { compare, technique } = this.settings;
    const isCompared = compare !== 'none';
    viewport.compareWith(isCompared ? () => divider.present?.share ?? 0.5 : undefined);
    if (isCompared && !divider.present) {
      divider.use(() => this.refresh());
      return;
    }
    const { choices } = SETTINGS.technique;
    divider.present?.show(isCompared ? { left: choices[compare], right: choices[technique] } : undefined);
  }

  /** To be called after each frame, because the viewport may have another size. */
  place(): void {
    if (!page.divider.hidden) this.divider.present?.place();
  }
}

/**
 * What lies over the drawing: the handles of the lights, the divider of a comparison, the frame of a sheet, and the hint that a model is
 * the wrong way up.
 */
export class Overlays {
  private readonly lights: LaterPart<LightHandles>;
  private readonly sheetFrame: LaterPart<SheetFrame>;

  constructor(session: Session, parts: LaterParts) {
    const { viewport, settings } = session;
    this.lights = parts.later(async () => {
      const { LightHandles } = await import('./LightHandles.js');
      return new LightHandles(viewport, settings, (source) => session.recordChange(source));
    });
    this.sheetFrame = parts.later(async () => {
      const { SheetFrame } = await import('./SheetFrame.js');
      return new SheetFrame(viewport, settings);
    });
    const comparison = new Comparison(viewport, settings, parts);
    const turnHint = new TurnHint(page.turnHint, settings, () => session.recordChange());
    session.listen({
      applied: () => {
        comparison.refresh();
        turnHint.refresh();
        this.sheetFrame.present?.refresh();
      },
      modelShown: () => turnHint.about(settings.model === 'file' ? viewport.model?.stands : undefined),
    });
    const follow = (): void => {
      this.lights.present?.update();
      comparison.place();
    };
    viewport.frames.onFrame(follow);
    viewport.frames.onWait(follow);
    this.lights.use(() => viewport.frames.invalidate());
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
