import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import type { Stage } from '../viewport/Stage.js';
import { page } from '../elements/page.js';
import type { LaterPart, LaterParts } from '../tasks/LaterParts.js';
import type { CompareDivider } from './CompareDivider.js';

/** Compares two techniques side by side, with a divider between them, while the settings ask for that. */
export class Comparison {
  private readonly divider: LaterPart<CompareDivider>;

  constructor(
    private readonly stage: Stage,
    private readonly settings: Settings,
    parts: LaterParts,
  ) {
    this.divider = parts.later(async () => {
      const { CompareDivider } = await import('./CompareDivider.js');
      return new CompareDivider(page.divider, page.viewport, () => stage.frames.invalidate());
    });
  }

  /** To be called when the settings have changed. */
  refresh(): void {
    const { stage, divider } = this;
    const { compare, technique } = this.settings;
    const isCompared = compare !== 'none';
    stage.compareWith(isCompared ? () => divider.present?.share ?? 0.5 : undefined);
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
