import { Drawing } from './Drawing.js';
import { elementStyle } from './elementStyle.js';
import { Painter } from './Painter.js';
import { readControls, readLight, readPreset } from './readAttributes.js';
import { type Arrangement, ViewControls } from './ViewControls.js';

const PROPERTIES = {
  src: 'src',
  preset: 'preset',
  light: 'light',
  controls: 'controls',
  alt: 'alt',
  poster: 'poster',
  'draco-path': 'dracoPath',
  'ktx2-path': 'ktx2Path',
} as const;
/** Those of what is loaded. */
const OF_MODEL: readonly string[] = ['src', 'preset', 'draco-path', 'ktx2-path'];
/** How far from the visible part of the page a model is loaded, in pixels. */
const LOAD_MARGIN = '300px';
/** More pixels than this per CSS pixel cost much and show little. */
const MOST_PIXEL_RATIO = 2;
const EYE = { azimuth: 0, elevation: 8 } as const;
const HINT = 'Arrow keys turn the model, with Shift the light; plus and minus zoom, Home takes all back.';

// A server has no elements; the class is there all the same, for whoever imports it.
const Base = globalThis.HTMLElement ?? (class {} as unknown as typeof HTMLElement);

/**
 * `<hatched-model src="model.glb">`: a model, hatched.
 *
 * | attribute | |
 * | --- | --- |
 * | `src` | address of a glTF or GLB file |
 * | `preset` | name of a preset of the library; `pen` by default |
 * | `light` | azimuth and elevation of the light, in degrees: `-45 40` |
 * | `controls` | lets visitors turn the model and its light; `controls="light"` the light alone |
 * | `alt` | what is to be seen, in words; empty for mere decoration |
 * | `poster` | address of a picture that is shown until the drawing is there |
 * | `draco-path` | address of a folder with three.js's decoder of Draco, for models packed with it |
 * | `ktx2-path` | address of a folder with three.js's decoder of KTX2, for models with such pictures |
 *
 * It loads when it comes near the visible part of the page, and draws when something changes. The events `load` and `error` (an
 * `ErrorEvent` with a sentence as message) say how loading ended. `::part(poster)` and `::part(error)` can be styled.
 */
export class HatchedModelElement extends Base {
  static readonly observedAttributes: readonly string[] = Object.keys(PROPERTIES);

  declare src: string;
  declare preset: string;
  declare light: string;
  declare controls: string;
  declare alt: string;
  declare poster: string;
  declare dracoPath: string;
  declare ktx2Path: string;

  private readonly canvas = document.createElement('canvas');
  private readonly image = document.createElement('img');
  private readonly message = document.createElement('p');
  private readonly arrangement: Arrangement = home(null);
  private viewControls: ViewControls | undefined;
  private painter: Painter | undefined;
  private drawing: Drawing | undefined;
  private loading: AbortController | undefined;
  private near: IntersectionObserver | undefined;
  private resizes: ResizeObserver | undefined;
  private isNear = false;
  private needsModel = true;
  private hasFailed = false;
  private frame = 0;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    root.adoptedStyleSheets = [elementStyle()];
    this.image.part.add('poster');
    this.image.alt = '';
    this.image.hidden = true;
    this.message.part.add('error');
    this.message.setAttribute('role', 'alert');
    this.message.hidden = true;
    root.append(this.image, this.canvas, this.message);
  }

  connectedCallback(): void {
    // Moved within the page, it has kept everything.
    if (this.near) return;
    this.viewControls = new ViewControls(
      this.canvas,
      this.arrangement,
      () => home(this.getAttribute('light')),
      this.invalidate,
    );
    Object.assign(this.arrangement.light, home(this.getAttribute('light')).light);
    this.near = new IntersectionObserver(this.onNear, { rootMargin: LOAD_MARGIN });
    this.near.observe(this);
    this.resizes = new ResizeObserver(this.invalidate);
    this.resizes.observe(this);
    this.needsModel = true;
    this.showAlt();
    this.showControls();
    this.showPoster();
  }

  disconnectedCallback(): void {
    // Whoever moves an element takes it out and puts it in again, in one task.
    queueMicrotask(() => {
      if (!this.isConnected) this.release();
    });
  }

  attributeChangedCallback(name: keyof typeof PROPERTIES): void {
    // What is set before the element stands in a page is read then.
    if (!this.near) return;
    if (OF_MODEL.includes(name)) this.askForModel();
    else if (name === 'light') this.showLight();
    else if (name === 'controls') this.showControls();
    else if (name === 'alt') this.showAlt();
    else this.showPoster();
  }

  private readonly onNear = (entries: IntersectionObserverEntry[]): void => {
    this.isNear = entries.at(-1)!.isIntersecting;
    this.loadWhenNear();
    this.invalidate();
  };

  private askForModel(): void {
    this.needsModel = true;
    // Attributes that are set together count as one change.
    queueMicrotask(() => this.loadWhenNear());
  }

  private loadWhenNear(): void {
    if (!this.isNear || !this.needsModel) return;
    this.needsModel = false;
    void this.load();
  }

  /** Loads the model in the preset. What was drawn before stays until it is there. */
  private async load(): Promise<void> {
    this.loading?.abort();
    const loading = new AbortController();
    this.loading = loading;
    this.hasFailed = false;
    try {
      if (!this.src) {
        this.clear();
        return;
      }
      const preset = readPreset(this.getAttribute('preset'));
      readLight(this.getAttribute('light'));
      this.painter ??= Painter.acquire(this.onRestored);
      const drawing = await Drawing.load(
        {
          address: resolve(this.src),
          folders: { draco: folderOf(this.dracoPath), ktx2: folderOf(this.ktx2Path) },
          renderer: this.painter.renderer,
        },
        preset,
        pixelRatio(),
        loading.signal,
      );
      if (loading.signal.aborted) {
        drawing.dispose();
        return;
      }
      this.drawing?.dispose();
      this.drawing = drawing;
      this.say('');
      this.invalidate();
      this.dispatchEvent(new Event('load'));
    } catch (error) {
      if (loading.signal.aborted) return;
      this.hasFailed = true;
      this.fail(error as Error);
    }
  }

  private showLight(): void {
    try {
      Object.assign(this.arrangement.light, readLight(this.getAttribute('light')));
    } catch (error) {
      this.fail(error as Error);
      return;
    }
    this.say('');
    this.invalidate();
    // The light may have been what stood in the way.
    if (this.hasFailed) this.askForModel();
  }

  private fail(error: Error): void {
    this.say(error.message);
    this.dispatchEvent(new ErrorEvent('error', { message: error.message, error }));
  }

  private say(sentence: string): void {
    this.message.textContent = sentence;
    this.message.hidden = sentence === '';
  }

  private showAlt(): void {
    const alt = this.getAttribute('alt');
    const { canvas } = this;
    canvas.setAttribute('role', alt === '' ? 'presentation' : 'img');
    if (alt === '') canvas.removeAttribute('aria-label');
    else canvas.setAttribute('aria-label', alt ?? 'Drawing of a model');
  }

  private showControls(): void {
    const mode = readControls(this.getAttribute('controls'));
    this.viewControls?.setMode(mode);
    if (mode === 'none') {
      this.canvas.removeAttribute('tabindex');
      this.canvas.removeAttribute('aria-description');
    } else {
      this.canvas.tabIndex = 0;
      this.canvas.setAttribute('aria-description', HINT);
    }
  }

  private showPoster(): void {
    this.image.hidden = !this.poster || this.drawing !== undefined;
    if (this.poster) this.image.src = this.poster;
  }

  /** Asks for one frame. Further calls before it is drawn change nothing. */
  private readonly invalidate = (): void => {
    if (this.drawing && this.isNear) this.frame ||= requestAnimationFrame(this.draw);
  };

  private readonly onRestored = (): void => {
    this.drawing?.renewShadow();
    this.invalidate();
  };

  private readonly draw = (): void => {
    this.frame = 0;
    const { drawing, painter, canvas } = this;
    if (!drawing || !painter) return;
    const ratio = pixelRatio();
    const [width, height] = [this.clientWidth, this.clientHeight].map((size) => Math.round(size * ratio));
    if (width === 0 || height === 0) return;
    // Setting a size clears the canvas, even if it is the same.
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const { light, eye, zoom } = this.arrangement;
    drawing.setPixelRatio(ratio);
    drawing.arrange(light, eye, zoom, width / height);
    if (!painter.paint(drawing.scene, drawing.camera, drawing.paper, canvas)) return;
    canvas.dataset.drawn = '';
    this.image.hidden = true;
  };

  /** Frees everything. The element can be put into a page again, and then loads again. */
  private release(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.loading?.abort();
    this.near?.disconnect();
    this.resizes?.disconnect();
    this.viewControls?.dispose();
    this.clear();
    this.painter?.release(this.onRestored);
    this.near = this.resizes = this.viewControls = this.painter = this.loading = undefined;
    this.isNear = false;
  }

  /** Takes the drawing away. */
  private clear(): void {
    this.drawing?.dispose();
    this.drawing = undefined;
    delete this.canvas.dataset.drawn;
    // Its memory is needed for nothing any more.
    Object.assign(this.canvas, { width: 0, height: 0 });
    this.say('');
    this.showPoster();
  }
}

for (const [name, property] of Object.entries(PROPERTIES)) {
  Object.defineProperty(HatchedModelElement.prototype, property, {
    get(this: HTMLElement) {
      return this.getAttribute(name) ?? '';
    },
    set(this: HTMLElement, value: unknown) {
      if (value === null || value === undefined || value === false) this.removeAttribute(name);
      else this.setAttribute(name, value === true ? '' : String(value));
    },
    enumerable: true,
    configurable: true,
  });
}

const resolve = (address: string): string => new URL(address, document.baseURI).href;

/** With a slash at its end, written or not. */
const folderOf = (path: string): string | undefined => (path ? resolve(path.replace(/\/*$/, '/')) : undefined);

const pixelRatio = (): number => Math.min(devicePixelRatio, MOST_PIXEL_RATIO);

/** How everything stands at first. @param light the attribute, which may be wrong */
function home(light: string | null): Arrangement {
  let direction = readLight(null);
  try {
    direction = readLight(light);
  } catch {
    // Loading says so.
  }
  return { light: direction, eye: { ...EYE }, zoom: 1 };
}
