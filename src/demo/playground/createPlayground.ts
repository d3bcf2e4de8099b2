import { errorMessage } from '../files/errorMessage.js';
import type { ModelFile } from '../files/readModel.js';
import { setPageState } from '../page/setPageState.js';
import { LIGHT_LOOKS } from '../settings/lightLooks.js';
import { presetLook } from '../settings/presets.js';
import { SettingsHistory } from '../settings/SettingsHistory.js';
import { SETTINGS, type SettingKey, type Settings } from '../settings/settings.js';
import { readLink, writeLink } from '../settings/shareLink.js';
import { surprise } from '../settings/surprise.js';
import { createScene } from '../stage/createScene.js';
import { askForStrokes } from './askForStrokes.js';
import { CompareDivider } from './CompareDivider.js';
import { ContactSheet } from './ContactSheet.js';
import { dropFiles } from './dropFiles.js';
import { ExportActions } from './ExportActions.js';
import { Gallery } from './Gallery.js';
import { LightHandles } from './LightHandles.js';
import { MapLoader } from './MapLoader.js';
import { ModelLoader } from './ModelLoader.js';
import { MotionPanel } from './MotionPanel.js';
import { OcclusionLoader } from './OcclusionLoader.js';
import { PresetBar } from './PresetBar.js';
import { page } from './page.js';
import type { SettingsPanel } from './SettingsPanel.js';
import type { Status } from './Status.js';
import { sortDrop } from './sortDrop.js';
import { TaskRunner } from './TaskRunner.js';
import { TurnHint } from './TurnHint.js';

declare global {
  interface Window {
    /**
     * For tests: the number of frames drawn since the page was opened, and whether no model, map or frame is being
     * waited for. An idle page draws no frames.
     */
    __playground?: { readonly framesDrawn: number; readonly isIdle: boolean };
  }
}

/** Of some of them, whether there is a map at all depends. */
const MAP_SETTINGS: readonly SettingKey[] = ['mapStyle', 'mapSize', 'mapTones', 'mapSeed', 'technique', 'compare'];
const LINK_DELAY_MILLISECONDS = 400;

/**
 * Creates the parts of the page and connects them: controls to settings, settings to the drawing, files to the loaders.
 */
export function createPlayground(context: WebGL2RenderingContext, status: Status): void {
  const { settings, camera } = readLink(location.hash);
  const scene = createScene(page.canvas, context, page.viewport);
  const history = new SettingsHistory(settings);
  const tasks = new TaskRunner(status, {
    hasDrawing: () => scene.isComplete,
    onIdle: () => {
      showPageState();
      scene.invalidate();
    },
  });
  const contactSheet = new ContactSheet(page.contactSheet);
  const mapLoader = new MapLoader(scene, settings, tasks, contactSheet, () => recordChange());
  const modelLoader = new ModelLoader(scene, settings, history, tasks, (isNewModel) => {
    if (isNewModel) {
      motion.show(scene.model?.motion);
      turnHint.about(settings.model === 'file' ? scene.model?.stands : undefined);
    }
    applySettings();
  });
  const occlusion = new OcclusionLoader(scene, settings, tasks);
  const motion = new MotionPanel(page.motion, page.canvas, () => scene.invalidate());
  const turnHint = new TurnHint(page.turnHint, settings, recordChange);
  const exportActions = new ExportActions(scene, settings, modelLoader, status, currentLink);
  const lights = new LightHandles(scene, settings, recordChange);
  const divider = new CompareDivider(page.divider, page.viewport, () => scene.invalidate());
  const presets = new PresetBar(page.presets, settings, (name) => {
    Object.assign(settings, presetLook(name));
    recordChange();
    void mapLoader.showChosen();
  });
  // Not before the drawing: it would delay it.
  let panel: SettingsPanel | undefined;
  void import('./SettingsPanel.js').then(
    ({ SettingsPanel }) => {
      panel = new SettingsPanel(
        page.panel,
        settings,
        [
          { label: 'Show the map', group: 'Drawing', run: showMap },
          ...Object.entries(LIGHT_LOOKS).map(([label, look]) => ({
            label,
            group: 'Light' as const,
            run: () => {
              Object.assign(settings, look);
              recordChange();
            },
          })),
          { label: 'Show the whole model', group: 'View', run: scene.view.frame },
          { label: 'Save PNG', group: 'Picture', run: exportActions.savePng },
          { label: 'Copy a link to this drawing', group: 'Picture', run: exportActions.copyLink },
          { label: 'Copy the code for this look', group: 'Picture', run: exportActions.copyCode },
        ],
        (key) => {
          if (key === 'model') modelLoader.changeModel();
          if (MAP_SETTINGS.includes(key)) void mapLoader.showChosen();
          recordChange(key);
        },
      );
    },
    (error) => status.fail(`The settings could not be fetched: ${errorMessage(error)}.`),
  );

  Object.defineProperty(window, '__playground', {
    value: {
      get framesDrawn() {
        return scene.framesDrawn;
      },
      get isIdle() {
        return tasks.isIdle && !scene.isWaiting && !occlusion.isAwaited;
      },
    },
  });

  function showMap(): void {
    contactSheet.open();
    void mapLoader.showChosen(true);
  }

  // ── Settings ──

  let linkTimer: ReturnType<typeof setTimeout> | undefined;

  /**
   * Applies settings that the user has changed, and keeps the earlier ones for Undo.
   *
   * @param source see {@link SettingsHistory.changed}
   */
  function recordChange(source?: string): void {
    history.changed(source);
    applySettings();
  }

  function undo(): void {
    const before = history.undo();
    if (before) replaceSettings(before);
    applySettings();
  }

  /**
   * Replaces all settings and loads the model and the map they ask for.
   *
   * @param isFramed whether the camera goes to where it sees another model whole
   */
  function replaceSettings(next: Settings, isFramed = true): void {
    const { model } = settings;
    Object.assign(settings, next);
    if (settings.model !== model) modelLoader.changeModel(isFramed);
    void mapLoader.showChosen();
  }

  function applySettings(): void {
    scene.apply(settings);
    occlusion.update();
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
    panel?.refresh();
    presets.refresh();
    turnHint.refresh();
    page.undo.disabled = history.isEmpty;
    updateAddress();
  }

  /** Keeps the page's address up to date, so that a reload or a bookmark restores the drawing. */
  function updateAddress(): void {
    clearTimeout(linkTimer);
    linkTimer = setTimeout(() => window.history.replaceState(null, '', `#${currentLink()}`), LINK_DELAY_MILLISECONDS);
  }

  function currentLink(): string {
    return writeLink(settings, scene.view.isFramed ? undefined : scene.view.place);
  }

  scene.view.controls.addEventListener('change', updateAddress);
  addEventListener('hashchange', () => showDrawing(readLink(location.hash)));

  /** Shows another drawing; Undo goes back to this one. */
  function showDrawing({ settings: next, camera: place }: ReturnType<typeof readLink>): void {
    replaceSettings(next, place === undefined);
    if (place) scene.view.place = place;
    else scene.view.frame();
    recordChange();
  }

  const gallery = new Gallery(page.gallery, ({ link }) => showDrawing(readLink(link)));
  page.openGallery.addEventListener('click', () => {
    openCard(false);
    gallery.open();
  });
  let seed = Date.now();
  page.surprise.addEventListener('click', () => {
    replaceSettings(surprise(settings, seed++));
    recordChange();
  });

  // ── Frames ──

  scene.onFrame(() => {
    lights.update();
    motion.update();
    if (!page.divider.hidden) divider.place();
    if (tasks.isIdle && scene.isComplete) setPageState('ready');
  });
  scene.onFrameTime(() => {
    occlusion.update();
    const time = `${scene.frameMilliseconds?.toFixed(0)} ms`;
    page.frameTime.textContent = scene.isCoarse ? `${time}, coarse` : `${time} a frame`;
    page.frameTime.title = scene.isCoarse
      ? 'Drawn with half the resolution while it moves, because this machine is slow'
      : 'Time from the first command of a frame to its last pixel';
  });
  page.canvas.addEventListener('webglcontextlost', () => {
    setPageState('lost');
    mapLoader.releaseGraphics();
    status.addProblem(
      'context',
      scene.showsLastPicture
        ? 'The graphics card has let go of the drawing again. This is its last picture; reload the page to go on if it stays.'
        : 'The graphics card has let go of the drawing. It should come back by itself; if not, reload the page.',
    );
  });
  page.canvas.addEventListener('webglcontextrestored', () => {
    status.solveProblem('context');
    status.say('The drawing is back.');
    setPageState('loading');
    showPageState();
    scene.invalidate();
  });

  /** Shows that there is nothing to draw, and nothing that could still come. */
  function showPageState(): void {
    if (tasks.isIdle && !scene.isComplete && !context.isContextLost()) setPageState('failed');
  }

  // ── Files and buttons ──

  dropFiles(
    { overlay: page.drop, input: page.fileInput, buttons: [page.openFiles, page.openMap] },
    (files) => void showFiles(files),
    (error) => status.fail(`What was dropped could not be read: ${errorMessage(error)}`),
  );
  page.savePng.addEventListener('click', exportActions.savePng);
  page.saveMap.addEventListener('click', exportActions.saveMap);
  page.undo.addEventListener('click', undo);

  /** Shows a model, or draws with a map. */
  async function showFiles(dropped: readonly ModelFile[]): Promise<void> {
    const { kind, files } = sortDrop(dropped, modelLoader.shownFiles, !page.contactSheet.sheet.hidden);
    if (kind === 'model') await modelLoader.showFiles(files);
    else if (kind === 'map' || (await askForStrokes(files.map(({ name }) => name)))) await mapLoader.showFiles(files);
  }

  /** Opens or closes the card of settings, which narrow screens show on request only. */
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

  if (camera) scene.view.place = camera;
  applySettings();
  modelLoader.showChosen();
  void mapLoader.showChosen();
}
