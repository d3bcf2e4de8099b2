import { sheetOnView } from '../../print/printPlan.js';
import type { Settings } from '../../settings/settings.js';
import type { Stage } from '../../stage/Stage.js';
import { page } from '../elements/page.js';
import { drawnView } from '../elements/viewSize.js';

/**
 * The frame of the sheet that a picture will be saved on, over the drawing: what lies outside is dimmed. A model that is framed is
 * composed for the sheet meanwhile.
 */
export class SheetFrame {
  private readonly element = Object.assign(document.createElement('div'), { className: 'sheet-frame', hidden: true });
  private isWanted = false;

  constructor(
    private readonly stage: Stage,
    private readonly settings: Settings,
  ) {
    this.element.setAttribute('aria-hidden', 'true');
    page.canvas.after(this.element);
    new ResizeObserver(() => this.refresh()).observe(page.viewport);
  }

  /** Shows it, as long as the settings ask for a sheet; or hides it. */
  show(isWanted: boolean): void {
    this.isWanted = isWanted;
    this.refresh();
  }

  /** To be called when the settings have changed. */
  refresh(): void {
    const { element, stage } = this;
    const sheet = this.isWanted ? sheetOnView(this.settings, drawnView(stage)) : undefined;
    stage.view.sheet = sheet;
    element.hidden = !sheet;
    if (!sheet) return;
    const [width, height] = sheet.map((share) => `${(100 * share).toFixed(3)}%`);
    Object.assign(element.style, { width, height });
  }
}
