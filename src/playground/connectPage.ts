import { errorMessage } from '../viewer/files/common/ModelError.js';
import type { Dialogs } from './dialogs/Dialogs.js';
import type { Exports } from './export/Exports.js';
import { dropFiles } from './loading/dropFiles.js';
import { page, pageForm } from './page/page.js';
import { listenToKeys } from './pageKeys.js';
import type { Card } from './panel/Card.js';
import type { Session } from './session/Session.js';
import type { LaterParts } from './tasks/LaterParts.js';
import type { Status } from './tasks/Status.js';
import { sentenceFor } from './tasks/Status.js';

/** The objects that the page's buttons, keys and dropped files act on. */
export interface PageHandlers {
  session: Session;
  card: Card;
  dialogs: Dialogs;
  exports: Exports;
  parts: LaterParts;
  status: Status;
  fillScreen: () => void;
}

/** Connects the page's buttons, keys and dropped files. */
export function connectPage(handlers: PageHandlers): void {
  connectButtons(handlers);
  connectSteps(handlers.session);
  connectKeys(handlers, connectViews(handlers));
  if (pageForm === 'playground') connectDrops(handlers);
}

function connectButtons({ session, card, dialogs, exports, parts }: PageHandlers): void {
  const onClick = (button: HTMLElement, run: () => void): void => button.addEventListener('click', run);
  onClick(page.savePng, () => exports.run('savePng'));
  onClick(page.saveMap, () => exports.run('saveMap'));
  onClick(page.openKeys, () => dialogs.openKeys());
  onClick(page.recent, () => dialogs.openRecent());
  onClick(page.openGallery, () => {
    openCard(false);
    dialogs.openGallery();
  });
  for (const which of ['looks', 'views'] as const) {
    onClick(page.savedLooks[which], () => card.savedLooks.use((savedLooks) => savedLooks.open(which)));
  }
  let seed = Date.now();
  onClick(page.surprise, () =>
    parts.whenFetched(import('../viewer/settings/surprise.js'), ({ surprise }) =>
      session.useLook(surprise(session.settings, seed++)),
    ),
  );
  onClick(page.home, () => {
    page.home.href = `${location.pathname}#${session.link}`;
  });
  onClick(page.toggleCard, () => openCard(!page.card.classList.contains('is-open')));
}

/** Connects the button that shows another view. @returns what it does */
function connectViews({ session, parts, status }: PageHandlers): () => void {
  const views = parts.later(async () => new (await import('./loading/AnotherView.js')).AnotherView(session));
  const showNext = (): void =>
    parts.whenFetched(
      views.fetch().then((fetched) => fetched.showNext()),
      (sentence) => sentence && status.say(sentence),
    );
  page.anotherView.addEventListener('click', showNext);
  return showNext;
}

function connectSteps(session: Session): void {
  page.undo.addEventListener('click', () => session.undo());
  page.redo.addEventListener('click', () => session.redo());
  const stepped = (): void => {
    page.undo.disabled = !session.canUndo;
    page.redo.disabled = !session.canRedo;
  };
  session.listen({ stepped });
  stepped();
}

function connectKeys({ session, dialogs, fillScreen }: PageHandlers, showAnotherView: () => void): void {
  listenToKeys({
    close: () => openCard(false),
    fillScreen,
    showAnotherView,
    openKeys: pageForm === 'playground' ? () => dialogs.openKeys() : undefined,
    showView: (index) => session.views.choose(index),
    undo: () => session.undo(),
    redo: () => session.redo(),
  });
}

function connectDrops({ session, parts, status }: PageHandlers): void {
  dropFiles(
    { overlay: page.drop, input: page.fileInput, buttons: [page.openFiles, page.openMap] },
    (files) => {
      status.solveProblem('link');
      parts.whenFetched(import('./loading/openDropped.js'), ({ openDropped }) => {
        openDropped(files, session, !page.contactSheet.sheet.hidden).catch((error) => status.fail(sentenceFor(error)));
      });
    },
    (error) => status.fail(`The dropped files could not be read: ${errorMessage(error)}`),
  );
}

/** Opens or closes the card of settings, which narrow screens show on request only. */
function openCard(open: boolean): void {
  page.card.classList.toggle('is-open', open);
  page.toggleCard.setAttribute('aria-expanded', String(open));
}
