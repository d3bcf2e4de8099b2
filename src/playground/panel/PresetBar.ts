import type { PresetName } from 'three-hatching';
import { PRESET_LABELS, PRESET_NAMES } from '../../viewer/settings/presetLabels.js';
import { presetOf } from '../../viewer/settings/presets.js';
import type { Settings } from '../../viewer/settings/settings.js';

/** A row of buttons, one per preset. The one that the settings match is pressed. */
export class PresetBar {
  private readonly buttons: readonly (readonly [PresetName, HTMLButtonElement])[];

  constructor(
    container: HTMLElement,
    private readonly settings: Settings,
    onChoose: (name: PresetName) => void,
  ) {
    this.buttons = PRESET_NAMES.map((name) => {
      const button = Object.assign(document.createElement('button'), { type: 'button' });
      const picture = Object.assign(document.createElement('img'), { alt: '', src: `gallery/preset-${name}.webp` });
      button.append(picture, PRESET_LABELS[name]);
      button.addEventListener('click', () => onChoose(name));
      return [name, button] as const;
    });
    container.append(...this.buttons.map(([, button]) => button));
    this.refresh();
  }

  refresh(): void {
    const chosen = presetOf(this.settings);
    for (const [name, button] of this.buttons) button.setAttribute('aria-pressed', String(name === chosen));
  }
}
