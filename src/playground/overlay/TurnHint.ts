import type { UpAxis } from '../../viewer/files/mesh/findUpAxis.js';
import type { Settings } from '../../viewer/settings/settings.js';

/** Asks whether a model is the wrong way up, if its flat side suggests so, and turns it if the user agrees. */
export class TurnHint {
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
