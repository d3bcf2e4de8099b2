import { type Controller, GUI } from 'lil-gui';
import { type DrawnView, millimetresPerPixel } from '../../print/printPlan.js';
import { drawnSettings } from '../../settings/drawnSettings.js';
import { type NumberSetting, SETTING_GROUPS, type Setting, type SettingGroup } from '../../settings/Setting.js';
import { SETTING_KEYS, SETTINGS, type SettingKey, type Settings } from '../../settings/settings.js';
import { drawsWithMap } from '../../settings/settingValues.js';

/** The settings of lines, which have no effect without lines. */
const LINE_KEYS = SETTING_KEYS.filter((key) => SETTINGS[key].group === 'Lines' && key !== 'lines');

/** A button of the panel. */
export interface PanelAction {
  /** What changes with the settings is asked for with each change of them. */
  label: string | (() => string);
  group: SettingGroup;
  run: () => void;
}

/** The controls, built from the table of settings. Each has a label and a unit, and is reset by double-click. */
export class SettingsPanel {
  private readonly controllers = new Map<SettingKey, Controller>();
  private readonly changingLabels: (() => void)[] = [];
  /** The widths of strokes and lines in print, if the picture is saved in the chosen size. */
  private readonly printNotes = { strokeWidth: note(''), lineWidth: note('') };

  constructor(
    container: HTMLElement,
    private readonly settings: Settings,
    actions: readonly PanelAction[],
    onChange: (key: SettingKey) => void,
    private readonly drawnView: () => DrawnView,
    /** Called when a group is unfolded or folded. */
    onFold: (group: SettingGroup, isOpen: boolean) => void,
  ) {
    // Styled by our own style sheet, because the Content Security Policy forbids style elements.
    const gui = new GUI({ container, injectStyles: false, title: 'Settings' });
    const folders = SETTING_GROUPS.map((group, i) => {
      const folder = i === 0 ? gui : gui.addFolder(group).close();
      // Without lil-gui's own style sheet, its opening animation would never end.
      folder.openAnimated = (open) => {
        folder.open(open);
        // What a fold holds is seen at once: all of it, or its beginning if it is longer than the panel.
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
      const group = SETTING_GROUPS.find((one) => folderOf.get(one) === folder);
      if (group) onFold(group, !folder._closed);
    });
    for (const key of SETTING_KEYS) {
      const controller = this.add(folderOf.get(SETTINGS[key].group)!, key);
      controller.onChange(() => {
        this.refresh();
        onChange(key);
      });
      this.controllers.set(key, controller);
    }
    for (const { label, group, run } of actions) {
      const controller = folderOf.get(group)!.add({ run }, 'run');
      if (typeof label === 'string') controller.name(label);
      else this.changingLabels.push(() => controller.name(label()));
    }
    // Moves the folders behind the settings of the first group.
    const children = gui.$children;
    children.append(...[...children.children].filter((child) => child.classList.contains('lil-gui')));
    this.refresh();
  }

  /** Updates the controls after the settings were changed elsewhere. Hides those that have no effect. */
  refresh(): void {
    for (const [key, controller] of this.controllers) {
      controller.updateDisplay();
      const setting: Setting = SETTINGS[key];
      if (setting.kind === 'number') sayValue(controller, setting, Number(this.settings[key]));
    }
    for (const name of this.changingLabels) name();
    const { settings } = this;
    const isLocal = settings.lightKind !== 'directional';
    const techniques = [settings.technique, settings.compare];
    const isAnchored = techniques.includes('anchored');
    const isCrisp = isAnchored || techniques.includes('adjacencyCrisp');
    const isEngraved = techniques.includes('engraved');
    const hasStrokes = techniques.some((technique) => technique !== 'engraved' && technique !== 'none');
    const isPaper = ['adjacency', 'adjacencyCrisp', 'triangle'].some((one) => (techniques as string[]).includes(one));
    this.show('screenConstancy', isAnchored || isEngraved);
    for (const key of ['lineField', 'lineSpacing', 'handmade', 'carved'] as const) this.show(key, isEngraved);
    this.show('strokeLayers', hasStrokes);
    // Dots have no direction and come from no map.
    const isMapped = drawsWithMap(settings);
    for (const key of ['mapStyle', 'strokeDirection'] as const) this.show(key, isMapped);
    const isCrossing = isEngraved || (hasStrokes && settings.strokeLayers === 'tone');
    for (const key of ['crossFrom', 'crossAngle'] as const) this.show(key, isCrossing);
    this.show('medium', isAnchored);
    this.show('anchorSpacing', isAnchored && isMapped);
    const isDry = isAnchored && settings.medium === 'dry';
    for (const key of ['tooth', 'toothSize', 'softness', 'smudge'] as const) this.show(key, isDry);
    this.show('creaseAngle', techniques.includes('adjacency') || techniques.includes('adjacencyCrisp'));
    this.show('strokeWidth', isCrisp || settings.levelRule === 'depth');
    this.show('edge', isCrisp);
    for (const key of ['offsetU', 'offsetV', 'levelRule'] as const) this.show(key, isPaper);
    // Strokes that are sized on the screen alone have no scale on the object.
    this.controllers
      .get('strokeScale')!
      .enable(
        !(
          settings.technique === 'anchored' &&
          ['none', 'anchored'].includes(settings.compare) &&
          settings.screenConstancy === 100
        ),
      );
    const isSheet = Number.isNaN(Number(settings.pictureSize));
    for (const key of ['pictureWidth', 'pictureHeight'] as const) this.show(key, settings.pictureSize === 'own');
    this.show('pictureTurn', isSheet && settings.pictureSize !== 'own');
    this.show('pictureDpi', isSheet);
    this.show('pictureGround', settings.pictureLayers === 'one');
    for (const [key, element] of Object.entries(this.printNotes)) {
      const width =
        drawnSettings(settings)[key as keyof typeof this.printNotes] * millimetresPerPixel(settings, this.drawnView());
      const where = isSheet ? 'on the sheet' : 'in print, 300 dpi';
      element.textContent = `${width.toFixed(2)} mm ${where}`;
    }
    for (const key of LINE_KEYS) this.show(key, settings.lines === 'on');
    this.show('strokeAngle', isMapped && settings.strokeDirection === 'angle');
    this.show('toneSteps', settings.toneModel === 'toon');
    this.show('shininess', settings.toneModel === 'phong');
    this.show('lightDistance', isLocal);
    for (const key of ['shadowStrokes', 'ground'] as const) this.show(key, settings.shadows === 'on');
    this.show('secondStrength', settings.secondLight !== 'none');
    for (const key of ['secondAzimuth', 'secondElevation'] as const) this.show(key, settings.secondLight === 'free');
    this.show('spotAngle', settings.lightKind === 'spot');
    this.show('spotSoftness', settings.lightKind === 'spot');
    for (const key of ['model', 'mapStyle'] as const) {
      this.controllers.get(key)!.domElement.querySelector<HTMLOptionElement>('option:last-child')!.hidden =
        settings[key] !== 'file';
    }
  }

  private show(key: SettingKey, visible: boolean): void {
    this.controllers.get(key)!.show(visible);
  }

  private add(gui: GUI, key: SettingKey): Controller {
    const setting: Setting = SETTINGS[key];
    const { settings } = this;
    switch (setting.kind) {
      case 'choice': {
        const choices = Object.fromEntries(Object.entries(setting.choices).map(([value, words]) => [words, value]));
        return this.finish(gui.add(settings, key, choices), setting);
      }
      case 'color':
        return this.finish(gui.addColor(settings, key), setting);
      case 'number': {
        const controller = gui.add(settings, key, setting.min, setting.max, setting.step);
        const unit = document.createElement('span');
        unit.className = 'unit';
        unit.textContent = setting.unit;
        controller.$widget.append(unit);
        if (setting.ends) controller.$widget.append(note(...setting.ends));
        if (key === 'strokeWidth' || key === 'lineWidth') controller.$widget.append(this.printNotes[key]);
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

/** Value, range and unit of a number, for who hears them: lil-gui has a plain field of text. */
function sayValue(controller: Controller, { min, max, unit }: NumberSetting, value: number): void {
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

/** A line of small text below a control. Several texts are spread over its width. */
function note(...texts: string[]): HTMLElement {
  const element = document.createElement('span');
  element.className = 'note';
  for (const text of texts) element.append(Object.assign(document.createElement('span'), { textContent: text }));
  return element;
}
