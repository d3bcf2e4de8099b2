import { findElement } from '../page/findElement.js';

/** The elements of index.html that the script works on. */
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
  modelCaption: findElement('model-caption'),
  frameTime: findElement('frame-time'),
  card: findElement('card'),
  presets: findElement('presets'),
  panel: findElement('panel'),
  motion: findElement('motion'),
  toggleCard: findElement('toggle-card'),
  openFiles: findElement('open-files'),
  savePng: findElement('save-png'),
  undo: findElement('undo') as HTMLButtonElement,
  gallery: {
    sheet: findElement('gallery'),
    drawings: findElement('gallery-drawings'),
    close: findElement('close-gallery'),
  },
  openGallery: findElement('open-gallery'),
  surprise: findElement('surprise'),
  contactSheet: {
    sheet: findElement('contact-sheet'),
    scroller: findElement('contact-sheet-scroller'),
    caption: findElement('contact-sheet-caption'),
    close: findElement('close-contact-sheet') as HTMLButtonElement,
  },
  saveMap: findElement('save-map'),
  openMap: findElement('open-map'),
  drop: findElement('drop'),
  ask: {
    dialog: findElement('ask') as HTMLDialogElement,
    question: findElement('ask-question'),
  },
  fileInput: findElement('file-input') as HTMLInputElement,
  status: {
    message: findElement('status'),
    progress: findElement('progress'),
    progressLine: findElement('progress-line'),
    cancel: findElement('cancel') as HTMLButtonElement,
  },
};
