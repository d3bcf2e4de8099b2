import type { Settings } from '../../viewer/settings/settings.js';
import { drawnView, page } from '../page/page.js';
import { sheetOnView } from '../print/printPlan.js';
import type { Viewport } from '../viewport/Viewport.js';

/**
 * A frame that shows the sheet of a saved picture, and dims what lies outside. While it is shown, a framed model is composed for the sheet.
 */
export class SheetFrame {
  private readonly element = Object.assign(document.createElement('div'), { className: 'sheet-frame', hidden: true });
  private isWanted = false;

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
  ) {
    this.element.setAttribute('aria-hidden', 'true');
    page.canvas.after(this.element);
    new ResizeObserver(() => this.refresh()).observe(page.viewport);
  }

  /** Shows or hides the frame. It is visible only if the settings ask for a sheet. */
  show(isWanted: boolean): void {
    this.isWanted = isWanted;
    this.refresh();
  }

  /** Call this when the settings have changed. */
  refresh(): void {
    const { element, viewport } = this;
    const sheet = this.isWanted ? sheetOnView(this.settings, drawnView(viewport)) : undefined;
    viewport.view.sheet = sheet;
    element.hidden = !sheet;
    if (!sheet) return;
    const [width, height] = sheet.map((share) => `${(100 * share).toFixed(3)}%`);
    Object.assign(element.style, { width, height });
  }
}
