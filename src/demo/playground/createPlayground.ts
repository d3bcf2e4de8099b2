import type { TonalArtMap } from 'three-hatching';
import { TonalArtMapCache } from '../drawing/TonalArtMapCache.js';
import type { ModelFile } from '../files/readModel.js';
import { setPageState } from '../page/setPageState.js';
import { presetLook } from '../settings/presets.js';
import { SettingsHistory } from '../settings/SettingsHistory.js';
import { SETTINGS, type SettingKey, type Settings } from '../settings/settings.js';
import { readLink, writeLink } from '../settings/shareLink.js';
import { createScene } from '../stage/createScene.js';
import { LightHandle } from '../stage/LightHandle.js';
import { CompareDivider } from './CompareDivider.js';
import { ContactSheet } from './ContactSheet.js';
import { dropFiles } from './dropFiles.js';
import { download } from './handOver.js';
import { ModelDesk } from './ModelDesk.js';
import { MotionPanel } from './MotionPanel.js';
import { areOfMap, loadOwnMap, zipMap } from './OwnMap.js';
import { Panel } from './Panel.js';
import { PresetBar } from './PresetBar.js';
import { page } from './page.js';
import type { Status } from './Status.js';
import { TakeAway } from './TakeAway.js';
import { TaskBoard } from './TaskBoard.js';

declare global {
  interface Window {
    /**
     * For tests: how many frames the page has drawn since it was opened (an idle page draws none), and whether it is busy
     * with no model, no map and no frame.
     */
    __playground?: { readonly framesDrawn: number; readonly isIdle: boolean };
  }
}

const MAP_SETTINGS: readonly SettingKey[] = ['mapStyle', 'mapSize', 'mapTones', 'mapSeed'];
const LINK_DELAY_MILLISECONDS = 400;

/** Wires the page: settings to the drawing, files and models to the scene, and everything back to panel and caption. */
export function createPlayground(context: WebGL2RenderingContext, status: Status): void {
  const { settings, camera } = readLink(location.hash);
  const scene = createScene(page.canvas, context, page.plate);
  const history = new SettingsHistory(settings);
  const maps = new TonalArtMapCache();
  const tasks = new TaskBoard(status, () => scene.invalidate());
  const models = new ModelDesk(scene, settings, history, tasks, (isNewModel) => {
    if (isNewModel) motion.show(scene.model?.motion);
    settingsChanged();
  });
  const motion = new MotionPanel(page.motion, page.canvas, () => scene.invalidate());
  const takeAway = new TakeAway(scene, settings, models, status, currentLink);
  const lamp = new LightHandle(page.lamp, {
    plate: page.plate,
    camera: scene.camera,
    settings,
    lightPosition: scene.lightPosition,
    onMove: (place) => {
      Object.assign(settings, place);
      personChanged('lamp');
    },
    onDrag: (dragging) => {
      scene.view.controls.enabled = !dragging;
      if (dragging) page.lamp.classList.add('is-known');
    },
  });
  const contact = new ContactSheet(page.contact);
  const divider = new CompareDivider(page.divider, page.plate, () => scene.invalidate());
  const presets = new PresetBar(page.presets, settings, (name) => {
    Object.assign(settings, presetLook(name));
    personChanged();
    void showMap();
  });
  const panel = new Panel(
    page.panel,
    settings,
    [
      { label: 'Show the map', group: 'Drawing', run: () => contact.open() },
      { label: 'Show the whole model', group: 'View', run: scene.view.frame },
      { label: 'Save PNG', group: 'Picture', run: takeAway.savePng },
      { label: 'Copy a link to this drawing', group: 'Picture', run: takeAway.copyLink },
      { label: 'Copy the code for this look', group: 'Picture', run: takeAway.copyCode },
    ],
    (key) => {
      if (key === 'model') models.changeModel();
      if (MAP_SETTINGS.includes(key)) void showMap();
      personChanged(key);
    },
  );

  Object.defineProperty(window, '__playground', {
    value: {
      get framesDrawn() {
        return scene.framesDrawn;
      },
      get isIdle() {
        return tasks.isIdle && !scene.isWaiting;
      },
    },
  });

  // ── The drawing ──

  let linkTimer: ReturnType<typeof setTimeout> | undefined;

  /** @param thing what was changed; see {@link SettingsHistory.changed} */
  function personChanged(thing?: string): void {
    history.changed(thing);
    settingsChanged();
  }

  function undo(): void {
    const before = history.undo();
    if (before) replaceSettings(before);
    settingsChanged();
  }

  /** Puts other settings in force, with the model and the map they ask for. */
  function replaceSettings(next: Settings): void {
    const { model } = settings;
    Object.assign(settings, next);
    if (settings.model !== model) models.changeModel();
    void showMap();
  }

  function settingsChanged(): void {
    scene.apply(settings);
    const { compare, technique } = settings;
    const isCompared = compare !== 'none';
    scene.compareWith(isCompared ? () => divider.share : undefined);
    divider.show(
      isCompared
        ? { left: SETTINGS.technique.choices[compare], right: SETTINGS.technique.choices[technique] }
        : undefined,
    );
    page.sheet.style.setProperty('--paper', settings.paper);
    page.sheet.style.setProperty('--ink', settings.ink);
    panel.refresh();
    presets.refresh();
    page.undo.disabled = history.isEmpty;
    rememberInAddress();
  }

  /** Keeps the page's address such that a reload, or a bookmark, brings the same drawing back. */
  function rememberInAddress(): void {
    clearTimeout(linkTimer);
    linkTimer = setTimeout(() => window.history.replaceState(null, '', `#${currentLink()}`), LINK_DELAY_MILLISECONDS);
  }

  function currentLink(): string {
    return writeLink(settings, scene.view.isFramed ? undefined : scene.view.place);
  }

  scene.onFrame(() => {
    lamp.update();
    motion.update();
    if (!page.divider.hidden) divider.place();
    if (tasks.isIdle && scene.isComplete && document.documentElement.dataset.state === 'loading') setPageState('ready');
  });
  scene.onFrameTime(() => {
    const time = `${scene.frameMilliseconds?.toFixed(0)} ms`;
    page.frameTime.textContent = scene.isCoarse ? `${time}, coarse` : `${time} a frame`;
    page.frameTime.title = scene.isCoarse
      ? 'Drawn with half the resolution while it moves, because this machine is slow'
      : 'Time from the first command of a frame to its last pixel';
  });
  scene.view.controls.addEventListener('change', rememberInAddress);

  // ── Models and maps ──

  async function showMap(): Promise<void> {
    await tasks.run('map', async (report, signal) => {
      const onProgress = (progress: number): void => report('drawing strokes for the map', progress);
      const map = await maps.get(settings, { signal, onProgress }, scene.tonalArtMap);
      if (!signal.aborted) useMap(map);
    });
  }

  function useMap(map: TonalArtMap): void {
    scene.setTonalArtMap(map);
    contact.show(map, SETTINGS.mapStyle.choices[settings.mapStyle]);
  }

  async function showOwnMap(files: readonly ModelFile[]): Promise<void> {
    await tasks.run('map', async (report, signal) => {
      const onProgress = (progress: number): void => report('reading your images', progress);
      const map = await loadOwnMap(files, { signal, onProgress });
      signal.throwIfAborted();
      settings.mapStyle = 'file';
      useMap(map);
      maps.keep(map);
      personChanged();
    });
  }

  async function saveMap(): Promise<void> {
    const map = scene.tonalArtMap;
    if (!map) return;
    download(await zipMap(map), `${settings.mapStyle === 'file' ? 'map' : settings.mapStyle}.zip`);
    status.say('The map is saved.');
  }

  dropFiles({ veil: page.drop, input: page.fileInput, buttons: [page.openFiles, page.openMap] }, (files) => {
    void (areOfMap(files) ? showOwnMap(files) : models.showFiles(files));
  });

  page.savePng.addEventListener('click', takeAway.savePng);
  page.saveMap.addEventListener('click', () => void saveMap());
  page.undo.addEventListener('click', undo);

  // ── The card ──

  function openCard(open: boolean): void {
    page.card.classList.toggle('is-open', open);
    page.toggleCard.setAttribute('aria-expanded', String(open));
  }

  page.toggleCard.addEventListener('click', () => openCard(!page.card.classList.contains('is-open')));
  addEventListener('keydown', (event) => {
    if (event.key === 'Escape') openCard(false);
    const isTyping = event.target instanceof HTMLInputElement && event.target.type !== 'range';
    if ((event.ctrlKey || event.metaKey) && !event.shiftKey && event.key === 'z' && !isTyping) {
      event.preventDefault();
      undo();
    }
  });

  // ── The graphics context ──

  page.canvas.addEventListener('webglcontextlost', () => {
    setPageState('lost');
    status.fail('The graphics card has let go of the drawing. It should come back by itself; if not, reload the page.');
  });
  page.canvas.addEventListener('webglcontextrestored', () => {
    setPageState('loading');
    status.say('The drawing is back.');
    scene.invalidate();
  });

  addEventListener('hashchange', () => {
    const link = readLink(location.hash);
    replaceSettings(link.settings);
    if (link.camera) scene.view.place = link.camera;
    else scene.view.frame();
    personChanged();
  });

  if (camera) scene.view.place = camera;
  settingsChanged();
  models.showChosen();
  void showMap();
}
