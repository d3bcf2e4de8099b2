import type { UpAxis } from '../../files/mesh/findUpAxis.js';
import type { Settings } from '../../settings/settings.js';

/** Asks whether a model is the wrong way up, where its flat side says so, and turns it. */
export class TurnHint {
  /** The axis that points up by the model's flat side; undefined if nothing is known, or the user has looked at it. */
  private stands: UpAxis | undefined;

  /** @param onTurn called when the settings were changed */
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

  /** To be called when another model is shown. */
  about(stands: UpAxis | undefined): void {
    this.stands = stands;
    this.refresh();
  }

  refresh(): void {
    this.elements.hint.hidden = this.stands === undefined || this.stands === this.settings.upAxis;
  }
}
