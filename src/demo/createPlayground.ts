import { CompareDivider } from './CompareDivider.js';
import { codeSample } from './codeSample.js';
import { createScene } from './createScene.js';
import { bakeModel } from './DrawnModel.js';
import { dropFiles } from './dropFiles.js';
import { exportPng } from './exportPng.js';
import { LightHandle } from './LightHandle.js';
import { loadModelFiles } from './loadModelFiles.js';
import { modelCaption } from './modelCaption.js';
import { BUILT_IN_MODELS } from './models.js';
import { Panel } from './Panel.js';
import { triangleCount } from './PlainMesh.js';
import { PresetBar } from './PresetBar.js';
import { page, setPageState } from './page.js';
import { presetLook } from './presets.js';
import type { ModelFile } from './readModel.js';
import { SettingsHistory } from './SettingsHistory.js';
import type { Status } from './Status.js';
import { SETTINGS, type SettingKey, type Settings } from './settings.js';
import { readLink, writeLink } from './shareLink.js';
import { type Report, TaskBoard } from './TaskBoard.js';
import { TonalArtMapCache } from './TonalArtMapCache.js';
import { copyText, download } from './takeAway.js';

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
  const drawn = { model: settings.model as Settings['model'], name: '', mapKeys: '' };
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
      scene.controls.enabled = !dragging;
      if (dragging) page.lamp.classList.add('is-known');
    },
  });
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
      { label: 'Show the whole model', group: 'View', run: scene.frameModel },
      { label: 'Save PNG', group: 'Picture', run: savePng },
      { label: 'Copy a link to this drawing', group: 'Picture', run: copyLink },
      { label: 'Copy the code for this look', group: 'Picture', run: copyCode },
    ],
    (key) => {
      if (key === 'model') changeModel();
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
    if (settings.model !== model) changeModel();
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
    return writeLink(settings, scene.isFramed() ? undefined : scene.getView());
  }

  scene.onFrame(() => {
    lamp.update();
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
  scene.controls.addEventListener('change', rememberInAddress);

  // ── Models and maps ──

  async function showModel(
    model: Settings['model'],
    load: (report: Report, signal: AbortSignal) => Promise<LoadedModel>,
  ) {
    setPageState('loading');
    const end = await tasks.run('model', async (report, signal) => {
      const loaded = await load(report, signal);
      const count = triangleCount(loaded.read.mesh).toLocaleString('en');
      const baked = await bakeModel(loaded.read.mesh, {
        signal,
        onProgress: (progress) => report(`joining ${count} triangles`, progress),
      });
      signal.throwIfAborted();
      report('drawing', 1);
      Object.assign(drawn, { model, name: loaded.title });
      settings.model = model;
      if (model === 'file') settings.upAxis = loaded.read.upAxis;
      history.adopt();
      page.facts.replaceChildren(...modelCaption(loaded.title, baked, loaded.read.broken));
      document.title = `${loaded.title}, hatched`;
      settingsChanged();
      scene.setModel(baked, loaded.view);
      page.lamp.hidden = false;
    });
    if (end === 'failed') {
      // The old drawing stays, and the panel says so.
      settings.model = drawn.model;
      history.adopt();
      settingsChanged();
    }
  }

  function showBuiltIn(model: Exclude<Settings['model'], 'file'>): Promise<void> {
    return showModel(model, async (report, signal) => {
      const { title, view, load } = BUILT_IN_MODELS[model];
      report(`fetching ${title}`);
      return { title, view, read: await load({ signal, onStage: report }) };
    });
  }

  function showFiles(files: readonly ModelFile[]): Promise<void> {
    return showModel('file', async (report, signal) => {
      const read = await loadModelFiles(files, { signal, onStage: report });
      return { title: read.name, read };
    });
  }

  function changeModel(): void {
    if (settings.model === 'file') return;
    settings.upAxis = SETTINGS.upAxis.default;
    void showBuiltIn(settings.model);
  }

  async function showMap(): Promise<void> {
    await tasks.run('map', async (report, signal) => {
      const onProgress = (progress: number): void => report('drawing strokes for the map', progress);
      const map = await maps.get(settings, { signal, onProgress }, scene.tonalArtMap);
      if (!signal.aborted) scene.setTonalArtMap(map);
    });
  }

  dropFiles({ veil: page.drop, input: page.fileInput, buttons: [page.openFiles] }, (files) => void showFiles(files));

  // ── Taking it away ──

  async function savePng(): Promise<void> {
    try {
      const picture = await exportPng(scene, {
        width: page.plate.clientWidth,
        height: page.plate.clientHeight,
        scale: Number(settings.pictureSize),
        ground: settings.pictureGround,
      });
      download(
        picture,
        `${
          drawn.name
            .replace(/\.\w+$/, '')
            .replace(/\W+/g, '-')
            .toLowerCase() || 'drawing'
        }.png`,
      );
      status.say('The picture is saved.');
    } catch (error) {
      status.fail(error instanceof Error ? error.message : String(error));
    }
  }

  async function copyLink(): Promise<void> {
    const link = new URL(`#${currentLink()}`, location.href).href;
    window.history.replaceState(null, '', link);
    const where = (await copyText(link))
      ? 'The link is on the clipboard.'
      : "The link is in the browser's address line.";
    status.say(settings.model === 'file' ? `${where} It cannot carry your own model.` : where);
  }

  async function copyCode(): Promise<void> {
    if (await copyText(codeSample(settings))) status.say('The code is on the clipboard.');
    else status.fail('The browser does not let this page use the clipboard.');
  }

  page.savePng.addEventListener('click', savePng);
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
    if (link.camera) scene.setView(link.camera);
    else scene.frameModel();
    personChanged();
  });

  if (camera) scene.setView(camera);
  settingsChanged();
  if (settings.model !== 'file') void showBuiltIn(settings.model);
  void showMap();
}

interface LoadedModel {
  title: string;
  view?: [number, number, number] | undefined;
  read: Awaited<ReturnType<typeof loadModelFiles>>;
}
