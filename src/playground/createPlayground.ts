import type { Settings } from '../viewer/settings/settings.js';
import { savedFormat } from '../viewer/settings/settingValues.js';
import { type LinkedDrawing, readLink } from '../viewer/settings/shareLink.js';
import type { SettingGroup } from '../viewer/settings/table/rows.js';
import { connectPage } from './connectPage.js';
import { Dialogs } from './dialogs/Dialogs.js';
import { Exports } from './export/Exports.js';
import { GeometryLoader, OcclusionLoader } from './loading/bakeLoaders.js';
import { Overlays } from './overlay/Overlays.js';
import { PageState } from './PageState.js';
import { page, pageForm } from './page/page.js';
import { Card } from './panel/Card.js';
import { DrawingOpener } from './session/DrawingOpener.js';
import { linkedHand } from './session/DrawingState.js';
import { AddressWriter, DrawingStore } from './session/DrawingStore.js';
import { PageAddress } from './session/PageAddress.js';
import { RendererChoice } from './session/RendererChoice.js';
import { Session } from './session/Session.js';
import { LaterParts } from './tasks/LaterParts.js';
import type { Status } from './tasks/Status.js';
import { TaskRunner } from './tasks/TaskRunner.js';
import type { FrameQuality } from './viewport/FrameQuality.js';
import { Viewport } from './viewport/Viewport.js';

declare global {
  interface Window {
    /**
     * For tests: the number of frames drawn since the page was opened, and whether the drawing is final: no model, map, script or frame is
     * pending, and nothing fades. An idle page draws no frames.
     */
    __playground?: { readonly framesDrawn: number; readonly isIdle: boolean };
  }
}

/** Creates and connects the parts of the page, and opens the drawing of the page's address. */
export function createPlayground(context: WebGL2RenderingContext, status: Status): void {
  const address = new PageAddress();
  const linked = readLink(address.read());
  const viewport = new Viewport(page.canvas, context, page.viewport);
  const parts = new LaterParts(status);
  const tasks = new TaskRunner(status, {
    hasDrawing: () => viewport.isComplete,
    onIdle: () => state.tasksEnded(),
  });
  const session = new Session(viewport, linked.settings, tasks);
  session.views.list = linked.views;
  session.mapLoader.hand = linkedHand(linked.handText);
  const store = new DrawingStore(address, status, () => void showRecent(store));
  const opener = new DrawingOpener(session, address, store, status);
  const occlusion = new OcclusionLoader(viewport, session.settings, tasks);
  const geometries = new GeometryLoader(viewport, session.settings, tasks);
  const update = (): void => {
    geometries.update();
    occlusion.update();
  };
  session.listen({ applied: update });

  // Everything that the page shows over the drawing.
  const overlays = new Overlays(session, parts);
  const dialogs = new Dialogs(session, store, opener, parts);
  const exports = new Exports(session, address, status, tasks, geometries, parts);
  const switches = parts.later(async () => {
    const { FileSwitches } = await import('./parts/FileSwitches.js');
    return new FileSwitches(
      () => session.modelLoader.shown,
      (switched) => session.modelLoader.readSwitched(switched),
    );
  });
  session.listen({
    applied: () => switches.present?.refresh(),
    modelShown: () => {
      const { changes, switched, hidesBacks } = session.modelLoader.shown;
      if (switches.present || hidesBacks || changes.length + switched.length > 0)
        switches.use((shown) => shown.refresh());
    },
  });
  const fillScreen = (): void => {
    toggleFullScreen(page.sheet).catch(() => status.fail('The browser does not let the drawing fill the screen.'));
  };
  const createActions = async () =>
    (await import('./panel/SettingsPanel.js')).panelActions(session, exports, dialogs, parts, fillScreen);
  const renderers = new RendererChoice(session, parts, status);
  const onFold = (group: SettingGroup, isOpen: boolean): void => {
    if (group === 'Picture') overlays.showSheet(isOpen);
  };
  const card = new Card(session, status, parts, createActions, onFold, renderers);
  session.listen({ applied: () => showSettings(session.settings) });
  const isAwaited = (): boolean => geometries.isAwaited || occlusion.isAwaited || session.mapLoader.isAwaited;
  const state = new PageState(session, tasks, opener, status, () => overlays.hasLights, isAwaited);
  viewport.quality.onMeasured(() => {
    update();
    showFrameTime(viewport.quality);
  });

  connectPage({ session, card, dialogs, exports, parts, status, fillScreen });
  addEventListener('hashchange', opener.follow);
  const writer = pageForm === 'playground' ? keepDrawing({ session, address, store, opener, tasks, parts }) : undefined;
  opener.onEnd = () => {
    writer?.update();
    state.showIfFailed();
  };
  if (pageForm === 'kiosk') parts.whenFetched(import('./Kiosk.js'), ({ Kiosk }) => new Kiosk(opener.follow));
  // The wheel scrolls the surrounding page until the drawing has the focus.
  if (pageForm === 'embed') viewport.view.zoomsWhenFocused(page.canvas);
  const isIdle = (): boolean =>
    tasks.isIdle && viewport.frames.isSettled && !isAwaited() && !parts.isFetching && !opener.isOpening;
  showToTests(viewport, isIdle);
  if (pageForm === 'playground') void showRecent(store);
  openFirst(linked, session, opener, pageForm === 'playground' ? address.drawing : undefined);
}

/**
 * Stores the drawing in the browser, with its address and the user's own files. Must not be called in embed or kiosk form, whose address
 * belongs to the drawing that visitors are shown.
 */
function keepDrawing({
  session,
  address,
  store,
  opener,
  tasks,
  parts,
}: {
  session: Session;
  address: PageAddress;
  store: DrawingStore;
  opener: DrawingOpener;
  tasks: TaskRunner;
  parts: LaterParts;
}): AddressWriter {
  const { viewport } = session;
  const keptPicture = parts.later(async () => {
    const { KeptPicture } = await import('./session/KeptPicture.js');
    const isSettled = (): boolean => tasks.isIdle && !opener.isOpening;
    return new KeptPicture(viewport, isSettled, (picture) => store.pictured(picture));
  });
  viewport.frames.onFrame(() => keptPicture.present?.frameDrawn());
  // Without the script, a drawing is stored without a thumbnail.
  const wantPicture = (): void =>
    parts.whenFetched(
      keptPicture.fetch().catch(() => undefined),
      (picture) => picture?.want(),
    );
  return new AddressWriter(session, address, store, wantPicture, () => opener.isOpening);
}

/** Opens the first drawing. @param kept the id of the stored drawing of the present history entry, if there is one */
function openFirst(
  { camera, address, choice }: LinkedDrawing,
  session: Session,
  opener: DrawingOpener,
  kept: string | undefined,
): void {
  const { viewport, modelLoader, mapLoader } = session;
  if (camera) viewport.view.place = camera;
  session.start();
  if (kept !== undefined) {
    void opener.openKept(kept).then(() => session.forgetSteps());
    return;
  }
  if (address === undefined) modelLoader.showChosen(choice);
  else opener.openAddress(address, camera === undefined, choice);
  void mapLoader.showChosen();
}

/** Shows the settings that affect the page itself: its colours, and the format of saved pictures. */
function showSettings(settings: Settings): void {
  page.sheet.style.setProperty('--paper', settings.paper);
  page.sheet.style.setProperty('--ink', settings.ink);
  page.saveFormat.textContent = savedFormat(settings);
  page.savePng.setAttribute('aria-label', `Save ${savedFormat(settings)}`);
}

function showFrameTime({ milliseconds, isCoarse }: FrameQuality): void {
  if (milliseconds === undefined) {
    page.frameTime.textContent = '';
    return;
  }
  const time = `${milliseconds.toFixed(0)} ms a frame`;
  page.frameTime.textContent = isCoarse
    ? `${time}; half the resolution while it moves, because this machine is slow`
    : time;
}

/** Shows the button of recent drawings, if there are any. */
async function showRecent(store: DrawingStore): Promise<void> {
  page.recent.hidden = (await store.list()).length === 0;
}

function showToTests(viewport: Viewport, isIdle: () => boolean): void {
  Object.defineProperty(window, '__playground', {
    value: {
      get framesDrawn() {
        return viewport.frames.count;
      },
      get isIdle() {
        return isIdle();
      },
    },
  });
}

/** Toggles full screen for an element. Rejects where the browser does not allow it. */
async function toggleFullScreen(element: HTMLElement): Promise<void> {
  if (document.fullscreenElement) await document.exitFullscreen();
  else await element.requestFullscreen();
}
