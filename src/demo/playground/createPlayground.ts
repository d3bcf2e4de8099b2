import { errorMessage } from '../files/common/errorMessage.js';
import type { ModelFile } from '../files/readModel.js';
import { setPageState } from '../page/setPageState.js';
import { EditHistory } from '../settings/EditHistory.js';
import { LIGHT_LOOKS } from '../settings/lightLooks.js';
import { wholeLook } from '../settings/presets.js';
import { SETTINGS, type SettingKey, type Settings } from '../settings/settings.js';
import { savedFormat } from '../settings/settingValues.js';
import { readLink, writeLink } from '../settings/shareLink.js';
import { createScene } from '../stage/createScene.js';
import type { ContactSheet } from './dialogs/ContactSheet.js';
import type { Gallery } from './dialogs/Gallery.js';
import type { KeysDialog } from './dialogs/KeysDialog.js';
import type { RecentDialog } from './dialogs/RecentDialog.js';
import { page } from './elements/page.js';
import { pageForm } from './elements/pageForm.js';
import { drawnView } from './elements/viewSize.js';
import { toggleFullScreen } from './fullScreen.js';
import { dropFiles } from './loading/dropFiles.js';
import { MapLoader } from './loading/MapLoader.js';
import { ModelLoader, type OpenedModel } from './loading/ModelLoader.js';
import { OcclusionLoader } from './loading/OcclusionLoader.js';
import { sortDrop } from './loading/sortDrop.js';
import type { CompareDivider } from './overlay/CompareDivider.js';
import type { LightHandles } from './overlay/LightHandles.js';
import type { SheetFrame } from './overlay/SheetFrame.js';
import { TurnHint } from './overlay/TurnHint.js';
import { listenToKeys } from './pageKeys.js';
import type { MotionPanel } from './panel/MotionPanel.js';
import { PresetBar } from './panel/PresetBar.js';
import type { SettingsPanel } from './panel/SettingsPanel.js';
import { type DrawingState, isSameState, type LookState } from './session/DrawingState.js';
import { Keeper } from './session/Keeper.js';
import { KeptPicture } from './session/KeptPicture.js';
import type { LinkFollower } from './session/LinkFollower.js';
import { PageAddress } from './session/PageAddress.js';
import { watchPresses } from './session/watchPresses.js';
import { SavedViews } from './shelf/SavedViews.js';
import type { Shelf } from './shelf/Shelf.js';
import type { CodeDialog } from './takeAway/CodeDialog.js';
import { copyPicture } from './takeAway/copyPicture.js';
import type { ExportActions } from './takeAway/ExportActions.js';
import type { Status } from './tasks/Status.js';
import { sentenceFor } from './tasks/sentenceFor.js';
import { TaskRunner } from './tasks/TaskRunner.js';

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
  const address = new PageAddress();
  const { settings, camera, address: linked, views: linkedViews } = readLink(address.read());
  const scene = createScene(page.canvas, context, page.viewport);
  /** Whether the parts of the page that nobody has opened yet are being fetched, which they are once there is a drawing. */
  let fetchesRest = false;
  const tasks = new TaskRunner(status, {
    hasDrawing: () => scene.isComplete,
    onIdle: () => {
      // Nobody waits for them: what does not come is fetched again when it is opened. Within other pages little can be opened.
      if (!fetchesRest && pageForm !== 'embed') {
        fetchesRest = true;
        import('./fetchRest.js').then(({ fetchRest }) => fetchRest()).catch(() => {});
      }
      showPageState();
      scene.invalidate();
    },
  });
  let contactSheet: ContactSheet | undefined;
  const mapLoader = new MapLoader(
    scene,
    settings,
    tasks,
    () => contactSheet && fillSheet(contactSheet),
    (isRestored) => (isRestored ? applySettings() : recordChange()),
    () => {
      applySettings();
      history.adopt();
    },
  );
  const modelLoader = new ModelLoader(scene, settings, tasks, (end, opened) => {
    if (opened) takeOver(opened);
    if (end !== 'failed') {
      showMotion();
      turnHint.about(settings.model === 'file' ? scene.model?.stands : undefined);
    }
    if (end === 'opened') recordChange();
    else {
      applySettings();
      history.adopt();
    }
  });
  const views = new SavedViews(scene, settings, () => recordChange());
  views.list = linkedViews;
  const history = new EditHistory(readState, isSameState, watchPresses());
  const keeper = new Keeper(address, status, () => void showRecent());
  const occlusion = new OcclusionLoader(scene, settings, tasks);
  const turnHint = new TurnHint(page.turnHint, settings, recordChange);
  let divider: CompareDivider | undefined;
  const presets = new PresetBar(page.presets, settings, (name) => useLook(wholeLook(name)));
  let shelf: Shelf | undefined;
  const fetchedShelf = import('./shelf/Shelf.js').then(({ Shelf }) => {
    shelf = new Shelf(scene, settings, views, useLook);
    return shelf;
  });
  const keptPicture = new KeptPicture(
    scene,
    () => tasks.isIdle && following === 0,
    (picture) => keeper.pictured(picture),
  );
  // Not before the drawing: it would delay it. The shelf lies above the panel, and comes first so that nothing moves.
  let panel: SettingsPanel | undefined;
  void Promise.all([import('./panel/SettingsPanel.js'), fetchedShelf]).then(
    ([{ SettingsPanel }]) => {
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
          { label: 'Show the whole model', group: 'View', run: scene.view.frameForUser },
          ...(document.fullscreenEnabled
            ? [{ label: 'Full screen (F)', group: 'View' as const, run: fillScreen }]
            : []),
          { label: () => `Save ${savedFormat(settings)}`, group: 'Picture', run: exported('savePng') },
          { label: 'Copy the picture', group: 'Picture', run: copyDrawing },
          { label: 'Save with the model, as ZIP', group: 'Picture', run: exported('saveDrawing') },
          ...('share' in navigator
            ? [{ label: 'Share this drawing', group: 'Picture' as const, run: exported('share') }]
            : []),
          { label: 'Copy a link to this drawing', group: 'Picture', run: exported('copyLink') },
          { label: 'Code and embedding', group: 'Picture', run: openCode },
          { label: 'Record a video', group: 'Video', run: exported('saveVideo') },
        ],
        (key) => {
          if (key === 'model') modelLoader.changeModel();
          if (MAP_SETTINGS.includes(key)) void mapLoader.showChosen();
          recordChange(key);
        },
        () => drawnView(scene),
        (group, isOpen) => {
          if (group === 'Picture') showSheet(isOpen);
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
        return tasks.isIdle && !scene.isWaiting && !occlusion.isAwaited && fetching + following === 0;
      },
    },
  });

  // Dialogs and the like are fetched when they are first opened: all that is here delays the first drawing.
  let codeDialog: CodeDialog | undefined;
  let recent: RecentDialog | undefined;

  /** How many parts of the page are being fetched. */
  let fetching = 0;

  /** Opens what has to be fetched first. */
  function whenFetched<Part>(part: Promise<Part>, open: (part: Part) => unknown): void {
    fetching++;
    part
      .then(open)
      .catch(sayUnfetched)
      .finally(() => fetching--);
  }

  function sayUnfetched(error: unknown): void {
    status.fail(sentenceFor(error));
  }

  let lights: LightHandles | undefined;
  whenFetched(import('./overlay/LightHandles.js'), ({ LightHandles }) => {
    lights = new LightHandles(scene, settings, recordChange);
    scene.invalidate();
  });

  let motion: MotionPanel | undefined;
  /** Shows the controls of a model that moves. */
  function showMotion(): void {
    if (!motion && !scene.model?.motion) return;
    whenFetched(import('./panel/MotionPanel.js'), ({ MotionPanel }) => {
      motion ??= new MotionPanel(page.motion, page.canvas, () => scene.invalidate());
      motion.show(scene.model?.motion);
      scene.invalidate();
    });
  }

  let exportActions: ExportActions | undefined;
  const fetchExports = (): Promise<ExportActions> =>
    import('./takeAway/ExportActions.js').then(({ ExportActions }) => {
      exportActions ??= new ExportActions(
        scene,
        settings,
        modelLoader,
        status,
        tasks,
        currentLink,
        address,
        ownStrokes,
      );
      return exportActions;
    });

  /** What saves or hands on the drawing in one of several ways. */
  function exported(action: 'savePng' | 'saveDrawing' | 'saveVideo' | 'saveMap' | 'share' | 'copyLink'): () => void {
    return () => whenFetched(fetchExports(), (actions) => void actions[action]());
  }

  function copyDrawing(): void {
    const fetched = fetchExports();
    whenFetched(fetched, () => {});
    void copyPicture(() => fetched.then((actions) => actions.drawPicture()), status);
  }

  let sheetFrame: SheetFrame | undefined;
  function showSheet(isShown: boolean): void {
    whenFetched(import('./overlay/SheetFrame.js'), ({ SheetFrame }) => {
      sheetFrame ??= new SheetFrame(scene, settings);
      sheetFrame.show(isShown);
    });
  }

  function openCode(): void {
    whenFetched(import('./takeAway/CodeDialog.js'), ({ CodeDialog }) => {
      codeDialog ??= new CodeDialog({
        drawing: () => ({
          model: modelLoader.codeModel,
          settings: { ...settings },
          camera: scene.view.place,
          groundHeight: scene.groundHeight,
          aspect: scene.camera.aspect,
        }),
        embedAddress: () => new URL(`?embed#${currentLink()}`, location.href).href,
        isModelInLink: () => settings.model !== 'file' || modelLoader.address !== undefined,
      });
      return codeDialog.open();
    });
  }

  let keysDialog: KeysDialog | undefined;
  for (const [which, button] of Object.entries(page.shelf)) {
    button.addEventListener('click', () =>
      whenFetched(fetchedShelf, (fetched) => fetched.open(which as keyof typeof page.shelf)),
    );
  }

  function openKeys(): void {
    whenFetched(import('./dialogs/KeysDialog.js'), ({ KeysDialog }) => {
      keysDialog ??= new KeysDialog();
      keysDialog.open();
    });
  }
  page.openKeys.addEventListener('click', openKeys);

  function fillScreen(): void {
    toggleFullScreen(page.sheet).catch(() => status.fail('The browser does not let the drawing fill the screen.'));
  }

  function showMap(): void {
    whenFetched(import('./dialogs/ContactSheet.js'), ({ ContactSheet }) => {
      contactSheet ??= new ContactSheet(page.contactSheet);
      fillSheet(contactSheet);
      contactSheet.open();
    });
    void mapLoader.showChosen(true);
  }

  function fillSheet(sheet: ContactSheet): void {
    if (scene.tonalArtMap) sheet.show(scene.tonalArtMap, mapLoader.shownStyle);
  }

  // ── Settings ──

  let linkTimer: ReturnType<typeof setTimeout> | undefined;

  /**
   * Applies settings that the user has changed, and keeps the earlier ones for Undo.
   *
   * @param source see {@link EditHistory.changed}
   */
  function recordChange(source?: string): void {
    // Drawn first: what the view does by itself belongs to the step.
    applySettings();
    history.changed(source);
    showSteps();
  }

  function useLook(look: Partial<Settings>): void {
    Object.assign(settings, look);
    recordChange();
    void mapLoader.showChosen();
  }

  /** Undo and Redo: shows an earlier state, or the one that came after. */
  function step(state: DrawingState | undefined): void {
    if (state) showState(state);
    applySettings();
  }

  function readState(): DrawingState {
    return {
      settings: { ...settings },
      camera: scene.view.state,
      files: settings.model === 'file' ? modelLoader.ownFiles : undefined,
      views: views.list,
    };
  }

  /** Takes over settings and camera, and loads the model and the map that they ask for. */
  function showState(state: DrawingState): void {
    const { settings: next, camera: place, files } = state;
    // Files that are gone cannot be shown again.
    const { model } = settings;
    showLook({ ...state, settings: { ...next, ...(next.model === 'file' && !files && { model }) } });
    modelLoader.restore({ model: settings.model, files }, place === undefined || place.framedFor !== undefined);
  }

  /** Takes over settings, camera and views, and loads the map that they ask for. */
  function showLook({ settings: next, camera: place, views: kept }: LookState): void {
    Object.assign(settings, next);
    views.list = kept;
    void mapLoader.showChosen();
    // Framed by its shadow, too, which is that of the lights.
    scene.apply(settings);
    if (place) scene.view.state = place;
    else scene.view.frame();
  }

  function applySettings(): void {
    scene.apply(settings);
    occlusion.update();
    showComparison();
    page.sheet.style.setProperty('--paper', settings.paper);
    page.sheet.style.setProperty('--ink', settings.ink);
    page.saveFormat.textContent = savedFormat(settings);
    page.savePng.setAttribute('aria-label', `Save ${savedFormat(settings)}`);
    panel?.refresh();
    presets.refresh();
    shelf?.refresh();
    turnHint.refresh();
    sheetFrame?.refresh();
    showSteps();
    updateAddress();
  }

  function showComparison(): void {
    const { compare, technique } = settings;
    const isCompared = compare !== 'none';
    scene.compareWith(isCompared ? () => divider?.share ?? 0.5 : undefined);
    if (isCompared && !divider) {
      whenFetched(import('./overlay/CompareDivider.js'), ({ CompareDivider }) => {
        divider ??= new CompareDivider(page.divider, page.viewport, () => scene.invalidate());
        showComparison();
      });
      return;
    }
    divider?.show(
      isCompared
        ? { left: SETTINGS.technique.choices[compare], right: SETTINGS.technique.choices[technique] }
        : undefined,
    );
  }

  function showSteps(): void {
    page.undo.disabled = !history.canUndo;
    page.redo.disabled = !history.canRedo;
  }

  /** Keeps the page's address up to date, so that a reload or a bookmark restores the drawing; and what is kept of one's own. */
  function updateAddress(): void {
    // What a visitor does there is nobody's work, and the address is that of somebody else's drawing.
    if (pageForm !== 'playground') return;
    clearTimeout(linkTimer);
    linkTimer = setTimeout(writeAddress, LINK_DELAY_MILLISECONDS);
  }

  function writeAddress(): void {
    clearTimeout(linkTimer);
    linkTimer = undefined;
    // Written when the model is there: until then, what is shown and what is asked for are two drawings.
    if (following > 0 || address.isFollowed || modelLoader.isLoading) return;
    const files = {
      model: settings.model === 'file' ? modelLoader.ownFiles : undefined,
      map: ownStrokes(),
    };
    keeper.shown(files, modelLoader.title, currentLink(), scene.view.ownPlace);
    if (files.model || files.map) keptPicture.want();
  }

  function ownStrokes(): readonly ModelFile[] | undefined {
    return settings.mapStyle === 'file' ? mapLoader.ownFiles : undefined;
  }

  function currentLink(): string {
    return writeLink(settings, scene.view.ownPlace, modelLoader.address, views.list);
  }

  let gallery: Gallery | undefined;
  page.openGallery.addEventListener('click', () => {
    openCard(false);
    whenFetched(import('./dialogs/Gallery.js'), ({ Gallery }) => {
      gallery ??= new Gallery(page.gallery, ({ link }) => {
        showState({ ...readLink(link), files: undefined });
        recordChange();
      });
      gallery.open();
    });
  });
  let seed = Date.now();
  page.surprise.addEventListener('click', () => {
    whenFetched(import('../settings/surprise.js'), ({ surprise }) => {
      Object.assign(settings, surprise(settings, seed++));
      void mapLoader.showChosen();
      recordChange();
    });
  });
  scene.view.onMoved = () => {
    history.changed('camera');
    showSteps();
    shelf?.refresh();
    updateAddress();
  };
  // What was changed in the last moment, too.
  addEventListener('pagehide', () => {
    if (linkTimer !== undefined) writeAddress();
  });
  addEventListener('hashchange', followLink);
  if (pageForm === 'kiosk') whenFetched(import('./Kiosk.js'), ({ Kiosk }) => new Kiosk(followLink));
  // The wheel scrolls the page around it, until somebody has turned to the drawing.
  if (pageForm === 'embed') scene.view.zoomsWhenFocused(page.canvas);

  page.home.addEventListener('click', () => {
    page.home.href = `${location.pathname}#${currentLink()}`;
  });

  let links: LinkFollower | undefined;
  /** How many links are followed: the user is asked, or a kept drawing is read. */
  let following = 0;
  /** Shows a drawing that takes a while, and then lets the page's address be that of what is shown. */
  async function follow(show: (links: LinkFollower) => Promise<void>): Promise<void> {
    following++;
    status.solveProblem('link');
    try {
      const { LinkFollower } = await import('./session/LinkFollower.js');
      links ??= new LinkFollower({
        ...{ settings, address, keeper, modelLoader, mapLoader },
        ...{ showState, showLook, recordChange },
      });
      await show(links);
    } catch (error) {
      status.addProblem('link', sentenceFor(error));
    }
    following--;
    if (following === 0) modelLoader.showSomething();
    updateAddress();
    showPageState();
  }

  function followLink(): void {
    void follow((links) => links.follow());
  }

  function openKept(id: string): Promise<void> {
    return follow((links) => links.openKept(id));
  }

  /** Draws a model that was opened as it says itself. What is checked is checked as in a link; an address in it is of no use. */
  function takeOver({ isOther, drawing }: OpenedModel): void {
    if (isOther) views.list = [];
    if (!drawing) return;
    const { settings: next, camera: place, views: kept } = readLink(drawing.link);
    showLook({ settings: { ...next, model: settings.model }, camera: place, views: kept });
    if (drawing.strokes.length > 0) void mapLoader.showFiles(drawing.strokes, true).then(() => history.adopt());
  }

  /** Shows the way to kept drawings where there are any. */
  async function showRecent(): Promise<void> {
    page.recent.hidden = (await keeper.list()).length === 0;
  }

  // ── Frames ──

  scene.onFrame(() => {
    lights?.update();
    motion?.update();
    keptPicture.frameDrawn();
    if (!page.divider.hidden) divider?.place();
    if (tasks.isIdle && scene.isComplete && lights) setPageState('ready');
  });
  scene.onFrameTime(() => {
    occlusion.update();
    const time = `${scene.frameMilliseconds?.toFixed(0)} ms`;
    page.frameTime.textContent = scene.isCoarse
      ? `${time} a frame; half the resolution while it moves, because this machine is slow`
      : `${time} a frame`;
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
    status.solveProblem('context', 'The drawing is back.');
    setPageState('loading');
    showPageState();
    scene.invalidate();
  });

  /** Shows that there is nothing to draw, and nothing that could still come. */
  function showPageState(): void {
    if (tasks.isIdle && following === 0 && !scene.isComplete && !context.isContextLost()) setPageState('failed');
  }

  // ── Files and buttons ──

  if (pageForm === 'playground')
    dropFiles(
      { overlay: page.drop, input: page.fileInput, buttons: [page.openFiles, page.openMap] },
      (files) => void showFiles(files).catch(sayUnfetched),
      (error) => status.fail(`What was dropped could not be read: ${errorMessage(error)}`),
    );
  page.savePng.addEventListener('click', exported('savePng'));
  page.saveMap.addEventListener('click', exported('saveMap'));
  page.undo.addEventListener('click', () => step(history.undo()));
  page.redo.addEventListener('click', () => step(history.redo()));
  page.recent.addEventListener('click', () => {
    whenFetched(import('./dialogs/RecentDialog.js'), ({ RecentDialog }) => {
      recent ??= new RecentDialog(keeper, (id) => void openKept(id));
      return recent.open();
    });
  });

  /** Shows a model, or draws with a map. */
  async function showFiles(dropped: readonly ModelFile[]): Promise<void> {
    status.solveProblem('link');
    const { kind, files } = sortDrop(dropped, modelLoader.shownFiles, !page.contactSheet.sheet.hidden);
    if (kind === 'model') await modelLoader.showFiles(files);
    else {
      const isMap =
        kind === 'map' || (await (await import('./loading/ask.js')).askForStrokes(files.map(({ name }) => name)));
      if (isMap) await mapLoader.showFiles(files);
    }
  }

  /** Opens or closes the card of settings, which narrow screens show on request only. */
  function openCard(open: boolean): void {
    page.card.classList.toggle('is-open', open);
    page.toggleCard.setAttribute('aria-expanded', String(open));
  }

  page.toggleCard.addEventListener('click', () => openCard(!page.card.classList.contains('is-open')));
  listenToKeys({
    close: () => openCard(false),
    fillScreen,
    openKeys: pageForm === 'playground' ? openKeys : undefined,
    showView: (index) => views.choose(index),
    undo: () => step(history.undo()),
    redo: () => step(history.redo()),
  });

  if (camera) scene.view.place = camera;
  history.adopt();
  applySettings();
  if (pageForm === 'playground') void showRecent();
  if (pageForm === 'playground' && address.drawing !== undefined) {
    void openKept(address.drawing).then(() => history.clear());
  } else {
    if (linked === undefined) modelLoader.showChosen();
    else void follow((links) => links.showAddress(linked, camera === undefined));
    void mapLoader.showChosen();
  }
}
