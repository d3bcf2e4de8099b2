/** The elements of index.html that the script works on. */
export const page = {
  sheet: find('sheet'),
  plate: find('plate'),
  canvas: find('drawing') as HTMLCanvasElement,
  divider: find('divider'),
  lamp: find('lamp'),
  facts: find('facts'),
  frameTime: find('frame-time'),
  card: find('card'),
  presets: find('presets'),
  panel: find('panel'),
  motion: find('motion'),
  toggleCard: find('toggle-card'),
  openFiles: find('open-files'),
  savePng: find('save-png'),
  undo: find('undo') as HTMLButtonElement,
  contact: {
    sheet: find('contact'),
    scroller: find('contact-scroller'),
    caption: find('contact-caption'),
    close: find('close-contact') as HTMLButtonElement,
  },
  saveMap: find('save-map'),
  openMap: find('open-map'),
  drop: find('drop'),
  fileInput: find('file-input') as HTMLInputElement,
  status: {
    message: find('status'),
    progress: find('progress'),
    progressLine: find('progress-line'),
    cancel: find('cancel') as HTMLButtonElement,
  },
};

/** How far the page is: `loading`, `ready` to be used, `lost` without a graphics context, or `failed` for good. */
export function setPageState(state: 'loading' | 'ready' | 'lost' | 'failed'): void {
  document.documentElement.dataset.state = state;
}

function find(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`page: index.html has no element with the id "${id}"; add it back.`);
  return element;
}
