import { ABOUT_SQUARE } from '../../viewer/sceneSetup/framing.js';
import type { DrawnView } from '../print/printPlan.js';
import type { Viewport } from '../viewport/Viewport.js';
import { findElement } from './elements.js';

/** The elements of index.html that the scripts use. */
export const page = {
  sheet: findElement('sheet'),
  viewport: findElement('viewport'),
  canvas: findElement('drawing') as HTMLCanvasElement,
  divider: findElement('divider'),
  turnHint: {
    hint: findElement('turn-hint'),
    turn: findElement('turn-upright'),
    leave: findElement('leave-turned'),
  },
  lamp: findElement('lamp'),
  secondLamp: findElement('second-lamp'),
  modelCaption: {
    caption: findElement('model-caption'),
    about: findElement('about-model') as HTMLDetailsElement,
    notes: findElement('model-notes'),
    statistics: findElement('model-statistics'),
  },
  frameTime: findElement('frame-time'),
  bar: findElement('bar'),
  home: findElement('home') as HTMLAnchorElement,
  card: findElement('card'),
  presets: findElement('presets'),
  panel: findElement('panel'),
  motion: findElement('motion'),
  toggleCard: findElement('toggle-card'),
  openFiles: findElement('open-files'),
  savePng: findElement('save-png'),
  saveFormat: findElement('save-format'),
  undo: findElement('undo') as HTMLButtonElement,
  gallery: {
    sheet: findElement('gallery'),
    drawings: findElement('gallery-drawings'),
    close: findElement('close-gallery'),
  },
  openGallery: findElement('open-gallery'),
  surprise: findElement('surprise'),
  anotherView: findElement('another-view'),
  openKeys: findElement('open-keys'),
  savedLooks: { looks: findElement('open-looks'), views: findElement('open-views') },
  redo: findElement('redo') as HTMLButtonElement,
  recent: findElement('open-recent'),
  contactSheet: {
    sheet: findElement('contact-sheet'),
    scroller: findElement('contact-sheet-scroller'),
    caption: findElement('contact-sheet-caption'),
    close: findElement('close-contact-sheet') as HTMLButtonElement,
  },
  saveMap: findElement('save-map'),
  openMap: findElement('open-map'),
  drop: findElement('drop'),
  fileInput: findElement('file-input') as HTMLInputElement,
  status: {
    message: findElement('status'),
    progress: findElement('progress'),
    progressLine: findElement('progress-line'),
    cancel: findElement('cancel') as HTMLButtonElement,
    mend: findElement('mend') as HTMLButtonElement,
  },
};

/**
 * The form of the page by its query: `?embed` in a frame of another page, `?kiosk` on a public screen. Both show only the drawing and its
 * light handles.
 */
type PageForm = 'playground' | 'embed' | 'kiosk';

export const pageForm: PageForm = formOf(location.search);

function formOf(query: string): PageForm {
  const parameters = new URLSearchParams(query);
  if (parameters.has('kiosk')) return 'kiosk';
  return parameters.has('embed') ? 'embed' : 'playground';
}

// Read by the style sheet.
document.documentElement.dataset.form = pageForm;
document.documentElement.classList.toggle('is-bare', pageForm !== 'playground');

/** The size of the viewport in CSS pixels. */
export function viewSize(): { width: number; height: number } {
  const { clientWidth: width, clientHeight: height } = page.viewport;
  return { width, height };
}

/** The viewport's size, and the orientation of a sheet that suits the model; if either does, that of the viewport. */
export function drawnView({ view: { proportion } }: Viewport): DrawnView {
  const size = viewSize();
  const isSquare = Math.max(proportion, 1 / proportion) < ABOUT_SQUARE;
  return { ...size, isWide: isSquare ? size.width > size.height : proportion > 1 };
}
