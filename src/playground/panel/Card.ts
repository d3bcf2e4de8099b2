import type { PresetName } from 'three-hatching';
import { errorMessage } from '../../viewer/files/common/ModelError.js';
import { PRESET_LABELS, PRESET_NAMES } from '../../viewer/settings/presetLabels.js';
import { presetOf, wholeLook } from '../../viewer/settings/presets.js';
import type { Settings } from '../../viewer/settings/settings.js';
import type { SettingGroup } from '../../viewer/settings/table/rows.js';
import { element } from '../page/elements.js';
import { page } from '../page/page.js';
import type { PartsPanel } from '../parts/PartsPanel.js';
import type { SavedLooks } from '../savedLooks/SavedLooks.js';
import type { RendererChoice } from '../session/RendererChoice.js';
import type { Session } from '../session/Session.js';
import type { LaterPart, LaterParts } from '../tasks/LaterParts.js';
import type { Status } from '../tasks/Status.js';
import type { MotionPanel } from './MotionPanel.js';
import type { PanelAction, SettingsPanel } from './SettingsPanel.js';

/** A row of buttons, one per preset. The one that matches the settings is pressed. */
class PresetBar {
  private readonly buttons: readonly (readonly [PresetName, HTMLButtonElement])[];

  constructor(
    container: HTMLElement,
    private readonly settings: Settings,
    onChoose: (name: PresetName) => void,
  ) {
    this.buttons = PRESET_NAMES.map((name) => {
      const picture = element('img', { alt: '', src: `gallery/preset-${name}.webp` });
      const button = element('button', { type: 'button' }, picture, PRESET_LABELS[name]);
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

/** The card beside the drawing: presets, the user's looks and views, the settings, and the controls of animated models. */
export class Card {
  readonly savedLooks: LaterPart<SavedLooks>;
  private readonly motion: LaterPart<MotionPanel>;
  private readonly parts: LaterPart<PartsPanel>;
  private panel: SettingsPanel | undefined;

  /**
   * @param createActions imports the buttons of the panel
   * @param onFold called when a group of settings is folded or unfolded
   */
  constructor(
    private readonly session: Session,
    status: Status,
    parts: LaterParts,
    createActions: () => Promise<readonly PanelAction[]>,
    onFold: (group: SettingGroup, isOpen: boolean) => void,
    renderers: RendererChoice,
  ) {
    const { viewport, settings } = session;
    const presets = new PresetBar(page.presets, settings, (name) => session.useLook(wholeLook(name)));
    this.savedLooks = parts.later(async () => {
      const { ModelVariants, SavedLooks } = await import('../savedLooks/SavedLooks.js');
      const variants = new ModelVariants(session.modelLoader);
      return new SavedLooks(viewport, settings, session.views, variants, (look) => session.useLook(look));
    });
    this.motion = parts.later(async () => {
      const { MotionPanel } = await import('./MotionPanel.js');
      const invalidate = (): void => viewport.frames.invalidate();
      return new MotionPanel(page.motion, page.canvas, invalidate, (clip) => session.chooseClip(clip));
    });
    this.parts = parts.later(async () => {
      const { PartsPanel } = await import('../parts/PartsPanel.js');
      return new PartsPanel(session);
    });
    // The panel is fetched later, because it would delay the first drawing. The saved looks are above it and come first, so that nothing
    // moves.
    void Promise.all([import('./SettingsPanel.js'), createActions(), this.savedLooks.fetch()])
      .then(
        ([{ SettingsPanel }, actions]) => {
          this.panel = new SettingsPanel(
            session,
            actions,
            (group, isOpen) => {
              onFold(group, isOpen);
              if (group === 'More' && isOpen) void renderers.ask().then(() => this.panel?.refresh());
            },
            renderers,
          );
        },
        (error) => status.fail(`The settings could not be fetched: ${errorMessage(error)}.`),
      )
      .finally(() => page.panel.removeAttribute('aria-busy'));
    const refreshSaved = (): void => this.savedLooks.present?.refresh();
    session.listen({
      applied: () => {
        this.panel?.refresh();
        presets.refresh();
        refreshSaved();
      },
      moved: refreshSaved,
      modelShown: () => {
        this.showMotion();
        if (this.parts.present || viewport.model?.parts) this.parts.use((panel) => panel.show());
      },
    });
    viewport.frames.onFrame(() => this.motion.present?.update());
  }

  /** Shows the controls of an animated model. */
  private showMotion(): void {
    const { viewport } = this.session;
    if (!this.motion.present && !viewport.model?.motion) return;
    this.motion.use((panel) => {
      panel.show(viewport.model?.motion);
      viewport.frames.invalidate();
    });
  }
}
