import { findElement } from '../page/findElement.js';

/** The elements of index.html that the script works on. */
export const page = {
  sheet: findElement('sheet'),
  plate: findElement('plate'),
  canvas: findElement('drawing') as HTMLCanvasElement,
  divider: findElement('divider'),
  lamp: findElement('lamp'),
  facts: findElement('facts'),
  frameTime: findElement('frame-time'),
  card: findElement('card'),
  presets: findElement('presets'),
  panel: findElement('panel'),
  motion: findElement('motion'),
  toggleCard: findElement('toggle-card'),
  openFiles: findElement('open-files'),
  savePng: findElement('save-png'),
  undo: findElement('undo') as HTMLButtonElement,
  contact: {
    sheet: findElement('contact'),
    scroller: findElement('contact-scroller'),
    caption: findElement('contact-caption'),
    close: findElement('close-contact') as HTMLButtonElement,
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
  },
};
