import { type Controller, GUI } from 'lil-gui';
import { withBoldnessAndDensity } from '../../viewer/settings/lookOf.js';
import { LIGHT_LOOKS } from '../../viewer/settings/presets.js';
import { SETTING_KEYS, SETTINGS, type SettingKey, type Settings } from '../../viewer/settings/settings.js';
import { hasEffect, isChoiceKnown, looksOf, presentUnit, savedFormat } from '../../viewer/settings/settingValues.js';
import {
  type NumberSetting,
  SETTING_GROUPS,
  type Setting,
  type SettingGroup,
} from '../../viewer/settings/table/rows.js';
import type { Dialogs } from '../dialogs/Dialogs.js';
import type { Exports } from '../export/Exports.js';
import { element, findElement } from '../page/elements.js';
import { drawnView, page } from '../page/page.js';
import { millimetresPerPixel } from '../print/printPlan.js';
import type { Session } from '../session/Session.js';
import type { LaterParts } from '../tasks/LaterParts.js';

/** Choices that refer to the user's own hand or files. */
type OwnChoice = 'ownHand' | 'file';
const isOwn = (value: string): value is OwnChoice => value === 'ownHand' || value === 'file';

/** Widths that are also shown in millimetres of the print. */
const PRINTED = ['strokeWidth', 'outlineWidth'] as const;

/** A button of the panel. */
export interface PanelAction {
  /** A function is called at each change of the settings, for a label that depends on them. */
  label: string | (() => string);
  group: SettingGroup;
  run: () => void;
  /** Whether the button is shown. Default: always. */
  isShown?: (settings: Settings) => boolean;
}

/** The controls, created from the table of settings. Each has a label and a unit, and is reset by a double-click. */
export class SettingsPanel {
  private readonly controllers = new Map<SettingKey, Controller>();
  private readonly units = new Map<SettingKey, HTMLElement>();
  /** Update buttons that depend on the settings. */
  private readonly changing: (() => void)[] = [];
  private readonly rendererNote = note('');
  /** Notes with the widths of strokes and lines in print. */
  private readonly printNotes = { strokeWidth: note(''), outlineWidth: note('') };

  /**
   * @param onFold called when a group is unfolded or folded
   * @param renderers whether renderers can be chosen, and a note on the choice
   */
  constructor(
    private readonly session: Session,
    actions: readonly PanelAction[],
    onFold: (group: SettingGroup, isOpen: boolean) => void,
    private readonly renderers: { readonly isOffered: boolean; readonly note: string },
  ) {
    const { panel: container } = page;
    // Uses the page's style sheet, because the Content-Security-Policy forbids style elements.
    const gui = new GUI({ container, injectStyles: false, title: 'Settings' });
    const folders = SETTING_GROUPS.map((group, i) => {
      const folder = i === 0 ? gui : gui.addFolder(group).close();
      // Without lil-gui's own style sheet, its opening animation would never end.
      folder.openAnimated = (open) => {
        folder.open(open);
        // Scrolls to the content of an opened fold: all of it, or its beginning if it is longer than the panel.
        if (open) {
          folder.domElement.scrollIntoView({ block: 'nearest' });
          folder.$title.scrollIntoView({ block: 'nearest' });
        }
        return folder;
      };
      return [group, folder] as const;
    });
    const folderOf = new Map(folders);
    gui.onOpenClose((folder: GUI) => {
      const group = SETTING_GROUPS.find((name) => folderOf.get(name) === folder);
      if (group) onFold(group, !folder._closed);
    });
    for (const key of SETTING_KEYS) {
      const controller = this.add(folderOf.get(SETTINGS[key].group)!, key);
      controller.onChange(() => {
        this.refresh();
        session.settingChanged(key);
      });
      this.controllers.set(key, controller);
    }
    for (const { label, group, run, isShown } of actions) {
      const controller = folderOf.get(group)!.add({ run }, 'run');
      if (typeof label === 'string') controller.name(label);
      else this.changing.push(() => controller.name(label()));
      if (isShown) this.changing.push(() => controller.show(isShown(session.settings)));
    }
    // Puts the folders after the settings of the first group.
    const children = gui.$children;
    children.append(...[...children.children].filter((child) => child.classList.contains('lil-gui')));
    this.refresh();
  }

  /** Updates the controls after the settings have changed elsewhere. Hides or disables those without an effect. */
  refresh(): void {
    for (const controller of this.controllers.values()) controller.updateDisplay();
    for (const update of this.changing) update();
    const { settings } = this.session;
    const looks = looksOf(settings);
    for (const [key, controller] of this.controllers) {
      const isUsed = hasEffect(key, settings, looks) && (key !== 'renderer' || this.renderers.isOffered);
      const setting: Setting = SETTINGS[key];
      if (setting.staysInPlace) controller.enable(isUsed);
      else controller.show(isUsed);
      if (setting.kind === 'number') {
        const unit = presentUnit(key, looks);
        this.units.get(key)!.textContent = unit;
        sayValue(controller, setting, Number(settings[key]), unit);
      }
      if (setting.kind === 'choice') {
        const options = controller.domElement.querySelectorAll('option');
        for (const [i, value] of Object.keys(setting.choices).entries()) {
          options[i].disabled = value !== settings[key] && !isChoiceKnown(key, value, looks);
        }
      }
    }
    this.notePrintedWidths();
    this.rendererNote.textContent = this.renderers.note;
    for (const key of ['model', 'mapStyle'] as const) {
      const options = this.controllers.get(key)!.domElement.querySelectorAll('option');
      for (const [i, value] of Object.keys(SETTINGS[key].choices).entries()) {
        if (isOwn(value)) options[i].hidden = value !== settings[key] && !this.hasOwn(value);
      }
    }
  }

  /** Shows the widths of strokes and lines in print. */
  private notePrintedWidths(): void {
    const { settings, viewport } = this.session;
    const millimetres = millimetresPerPixel(settings, drawnView(viewport));
    const drawn = withBoldnessAndDensity(settings);
    const where = hasEffect('pictureDpi', settings) ? 'on the sheet' : 'in print, 300 dpi';
    for (const key of PRINTED) {
      this.printNotes[key].textContent = `${(drawn[key] * millimetres).toFixed(2)} mm ${where}`;
    }
  }

  /** Whether the user has a hand that can be chosen. The value `file` is set by opening files, not chosen here. */
  private hasOwn(value: OwnChoice): boolean {
    return value === 'ownHand' && this.session.mapLoader.hand?.hand !== undefined;
  }

  private add(gui: GUI, key: SettingKey): Controller {
    const setting: Setting = SETTINGS[key];
    const { settings } = this.session;
    switch (setting.kind) {
      case 'choice': {
        const choices = Object.fromEntries(Object.entries(setting.choices).map(([value, words]) => [words, value]));
        const controller = gui.add(settings, key, choices);
        if (key === 'renderer') controller.$widget.append(this.rendererNote);
        return this.finish(controller, setting);
      }
      case 'color':
        return this.finish(gui.addColor(settings, key), setting);
      case 'number': {
        const controller = gui.add(settings, key, setting.min, setting.max, setting.step);
        const unit = element('span', { className: 'unit' });
        this.units.set(key, unit);
        controller.$widget.append(unit);
        if (setting.ends) controller.$widget.append(note(...setting.ends));
        if (isPrinted(key)) controller.$widget.append(this.printNotes[key]);
        return this.finish(controller, setting);
      }
    }
  }

  private finish(controller: Controller, setting: Setting): Controller {
    controller.name(setting.label);
    controller.$name.title = 'Double-click to reset';
    controller.domElement.addEventListener('dblclick', (event) => {
      if (event.target instanceof HTMLInputElement && event.target.type === 'text') return;
      controller.setValue(setting.default);
    });
    return controller;
  }
}

const isPrinted = (key: SettingKey): key is (typeof PRINTED)[number] =>
  (PRINTED as readonly SettingKey[]).includes(key);

/** Gives screen readers the value, range and unit of a number, because lil-gui uses a plain text field. */
function sayValue(controller: Controller, { min, max }: NumberSetting, value: number, unit: string): void {
  const said = {
    role: 'spinbutton',
    'aria-valuenow': value,
    'aria-valuemin': min,
    'aria-valuemax': max,
    'aria-valuetext': `${value} ${unit}`.trim(),
  };
  const input = controller.$widget.querySelector('input');
  for (const [name, text] of Object.entries(said)) input?.setAttribute(name, String(text));
}

/** Creates a line of small text below a control. Several texts are spread over its width. */
const note = (...texts: string[]): HTMLElement =>
  element('span', { className: 'note' }, ...texts.map((text) => element('span', {}, text)));

/** The buttons of the panel by group of settings. */
export function panelActions(
  session: Session,
  exports: Exports,
  dialogs: Dialogs,
  parts: LaterParts,
  fillScreen: () => void,
): readonly PanelAction[] {
  const { viewport, settings } = session;
  const hand = parts.later(async () => {
    const { HandSheet } = await import('../hand/HandSheet.js');
    return new HandSheet(findElement('hand-sheet'), session);
  });
  const lights = Object.entries(LIGHT_LOOKS).map(
    ([label, look]): PanelAction => ({ label, group: 'Light', run: () => session.change(look) }),
  );
  const fullScreen: PanelAction = { label: 'Full screen (F)', group: 'View', run: fillScreen };
  const share: PanelAction = { label: 'Share this drawing', group: 'Picture', run: () => exports.run('share') };
  return [
    { label: 'Draw with your own hand', group: 'Drawing', run: () => hand.use((sheet) => sheet.open()) },
    { label: 'Show the map', group: 'Drawing', run: () => dialogs.showMap() },
    ...lights,
    { label: 'Show the whole model', group: 'View', run: viewport.view.frameForUser },
    ...(document.fullscreenEnabled ? [fullScreen] : []),
    { label: () => `Save ${savedFormat(settings)}`, group: 'Picture', run: () => exports.run('savePng') },
    { label: 'Save SVG, as lines', group: 'Picture', run: () => exports.run('saveSvg') },
    {
      label: 'Preview the plot',
      group: 'Picture',
      run: () => exports.run('previewPlot'),
      isShown: ({ pictureSvg }) => pictureSvg === 'pen',
    },
    { label: 'Copy the picture', group: 'Picture', run: () => exports.copy() },
    { label: 'Save with the model, as ZIP', group: 'Picture', run: () => exports.run('saveDrawing') },
    ...('share' in navigator ? [share] : []),
    { label: 'Copy a link to this drawing', group: 'Picture', run: () => exports.run('copyLink') },
    { label: 'Copy the facts for a report', group: 'Picture', run: () => exports.run('copyFacts') },
    { label: 'Code and embedding', group: 'Picture', run: () => exports.openCode() },
    { label: 'Record a video', group: 'Video', run: () => exports.run('saveVideo') },
  ];
}
