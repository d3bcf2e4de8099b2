import type { UpAxis } from '../../viewer/files/mesh/UpAxis.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { page } from '../page/page.js';
import type { Session } from '../session/Session.js';
import type { LaterPart, LaterParts } from '../tasks/LaterParts.js';
import type { Viewport } from '../viewport/Viewport.js';
import type { CompareDivider } from './CompareDivider.js';
import type { LightHandles } from './LightHandles.js';
import type { SheetFrame } from './SheetFrame.js';

/** Suggests turning a model upright if what it stands on indicates another up axis, and turns it if the user agrees. */
class TurnHint {
  /** The up axis suggested by what the model stands on. Undefined if there is none, or the user has closed the hint. */
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

  /** Shows the suggested up axis of another model, or removes the hint. */
  about(stands: UpAxis | undefined): void {
    this.stands = stands;
    this.refresh();
  }

  refresh(): void {
    this.elements.hint.hidden = this.stands === undefined || this.stands === this.settings.upAxis;
  }
}

/** Compares two techniques side by side with a divider, while the settings ask for that. */
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

  /** Call this when the settings have changed. */
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

  /** Call this after each frame, because the viewport may have been resized. */
  place(): void {
    if (!page.divider.hidden) this.divider.present?.place();
  }
}

/** The overlays of the drawing: light handles, comparison divider, sheet frame, and the hint that a model is the wrong way up. */
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

  /** Whether the light handles exist. */
  get hasLights(): boolean {
    return this.lights.present !== undefined;
  }

  /** Shows or hides the frame of the sheet for a saved picture. It is visible only if the settings ask for a sheet. */
  showSheet(isShown: boolean): void {
    this.sheetFrame.use((frame) => frame.show(isShown));
  }
}
