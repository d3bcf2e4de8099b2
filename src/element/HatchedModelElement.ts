import type { Hand, HatchingCompositionOptions, HatchingPreset } from 'three-hatching';
import { Drawing } from './Drawing.js';
import { elementStyle } from './elementStyle.js';
import { loadHand } from './loadHand.js';
import {
  type Direction,
  LOOK_NUMBERS,
  type LookNumber,
  readControls,
  readHand,
  readLight,
  readLookNumber,
  readPreset,
} from './readAttributes.js';
import { SharedRenderer } from './SharedRenderer.js';
import { type Arrangement, ViewControls } from './ViewControls.js';

let hasWarned = false;

/**
 * Warns once per page of an element that comes into view and never had a `src`. An element whose `src` was removed is empty on purpose.
 *
 * @param hadSource whether the element has had a `src` before
 */
export function warnOfMissingSource(hadSource: boolean): void {
  if (hadSource || hasWarned) return;
  hasWarned = true;
  console.warn('<hatched-model>: there is no src, so nothing is shown. Set src to the address of a glTF or GLB file.');
}

const ATTRIBUTES = [
  ...(['src', 'preset', 'hand', 'color-fill', 'color-hatching', 'exposure', 'vignette', 'light', 'camera'] as const),
  ...(['variant', 'controls', 'alt', 'poster', 'draco-path', 'ktx2-path'] as const),
];
/** The attributes whose change loads the model again, and those whose change draws it with another look. */
const OF_MODEL: readonly string[] = ['src', 'camera', 'variant', 'draco-path', 'ktx2-path'];
const OF_LOOK: readonly string[] = ['preset', 'hand', ...Object.keys(LOOK_NUMBERS)];
/** The distance from the visible part of the page at which a model is loaded. */
const LOAD_MARGIN = '300px';
/** The greatest number of pixels per CSS pixel. More take longer and show little. */
const MAX_PIXEL_RATIO = 2;
const EYE: Direction = { azimuth: 0, elevation: 8 };
/** The light until a model has loaded: from the upper left, as in most drawings of right-handed people. */
const FIRST_LIGHT: Direction = { azimuth: -45, elevation: 40 };
const HINT = 'Arrow keys turn the model, with Shift the light; plus and minus zoom; Home resets everything.';

// On a server there is no HTMLElement, but the module must be importable there too.
const Base = globalThis.HTMLElement ?? (class {} as unknown as typeof HTMLElement);

/**
 * `<hatched-model src="model.glb">` shows a hatched model.
 *
 * | attribute | meaning |
 * | --- | --- |
 * | `src` | URL of a glTF or GLB file |
 * | `preset` | name of a preset of the library; `pen` by default |
 * | `hand` | URL of a `hand.json`, whose strokes are drawn; the preset must draw with a pen |
 * | `color-fill` | how much of the model's own colours is printed under the ink, from 0 to 1; 0 by default |
 * | `color-hatching` | how much the darkness of these colours is hatched, from 0 to 1; 0.8 by default |
 * | `exposure` | how much lighter the drawing is, as a factor; 1 by default |
 * | `vignette` | how much strokes fade towards the rim, from 0 to 1; 0 by default |
 * | `light` | azimuth and elevation of the light in degrees, such as `-45 40`; by default that of the file, or one that suits the first view of the model |
 * | `camera` | the camera of the file that the first view is that of: its name, or its number from 1 on |
 * | `variant` | the variant of the materials of the file: its name, or its number from 1 on |
 * | `controls` | lets visitors turn the model and its light; with `controls="light"` only the light |
 * | `alt` | describes the picture in words; empty if it is decoration |
 * | `poster` | URL of a picture that is shown until the model is drawn |
 * | `draco-path` | URL of a folder with three.js's Draco decoder, for models compressed with Draco |
 * | `ktx2-path` | URL of a folder with three.js's KTX2 decoder, for models with KTX2 textures |
 *
 * The model is loaded when it comes near the visible part of the page, and drawn when something changes. The events `load` and
 * `error` (an `ErrorEvent` with a sentence as message) report the end of loading. `::part(poster)` and `::part(error)` can be styled.
 *
 * | state   | what is shown                     | leads to |
 * | ------- | --------------------------------- | -------- |
 * | apart   | nothing: it is in no page         | waiting, when it is inserted |
 * | waiting | the former drawing, or the poster | loading, when it is near the visible part of the page |
 * | loading | the former drawing, or the poster | drawn, empty or failed |
 * | drawn   | the drawing                       | waiting, when an attribute of the model or its look changes |
 * | empty   | the poster: there is no `src`     | waiting, when an attribute of the model changes |
 * | failed  | a sentence, over the former drawing | waiting, when an attribute of the model or `light` changes |
 *
 * From any state, removing the element from the page frees everything and leads to apart. A change while loading aborts the load.
 */
export class HatchedModelElement extends Base {
  static readonly observedAttributes: readonly string[] = ATTRIBUTES;

  declare src: string;
  declare preset: string;
  declare hand: string;
  declare colorFill: string;
  declare colorHatching: string;
  declare exposure: string;
  declare vignette: string;
  declare light: string;
  declare camera: string;
  declare variant: string;
  declare controls: string;
  declare alt: string;
  declare poster: string;
  declare dracoPath: string;
  declare ktx2Path: string;

  private readonly canvas = document.createElement('canvas');
  private readonly image = document.createElement('img');
  private readonly message = document.createElement('p');
  /** The light that suits the model. */
  private suitingLight = FIRST_LIGHT;
  /** The direction from the model to the camera of the first view. */
  private firstEye = EYE;
  private readonly arrangement: Arrangement = this.home;
  private state: 'apart' | 'waiting' | 'loading' | 'drawn' | 'empty' | 'failed' = 'apart';
  /** What watches the element and its visitors while it is in a page. */
  private watching: { controls: ViewControls; near: IntersectionObserver; resizes: ResizeObserver } | undefined;
  /** Aborts the latest load. */
  private loading = new AbortController();
  private painter: SharedRenderer | undefined;
  private drawing: Drawing | undefined;
  /** Whether the drawing is that of an earlier model. */
  private isOutdated = false;
  /** The hand that was fetched last, for other looks. */
  private fetchedHand: { address: string; hand: Hand } | undefined;
  private isNear = false;
  private hadSource = false;
  /** The frame that was requested, or 0. */
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
    // An element that was moved within the page has kept everything.
    if (this.watching) return;
    const near = new IntersectionObserver(this.onNear, { rootMargin: LOAD_MARGIN });
    const resizes = new ResizeObserver(this.invalidate);
    const controls = new ViewControls(this.canvas, this.arrangement, () => this.home, this.invalidate);
    this.watching = { controls, near, resizes };
    this.state = 'waiting';
    Object.assign(this.arrangement.light, this.home.light);
    near.observe(this);
    resizes.observe(this);
    this.showAlt();
    this.showControls();
    this.showPoster();
  }

  disconnectedCallback(): void {
    // Moving an element removes and inserts it in one task, so the release waits for a microtask.
    queueMicrotask(() => {
      if (!this.isConnected) this.release();
    });
  }

  attributeChangedCallback(name: (typeof ATTRIBUTES)[number]): void {
    // Attributes that are set before the element is connected are read when it is.
    if (this.state === 'apart') return;
    const isOfModel = OF_MODEL.includes(name);
    if (isOfModel) this.isOutdated = true;
    if (isOfModel || OF_LOOK.includes(name)) this.requestDrawing();
    else if (name === 'light') this.showLight();
    else if (name === 'controls') this.showControls();
    else if (name === 'alt') this.showAlt();
    else this.showPoster();
  }

  private readonly onNear = (entries: IntersectionObserverEntry[]): void => {
    this.isNear = entries.at(-1)!.isIntersecting;
    void this.load();
    this.invalidate();
  };

  private requestDrawing(): void {
    this.loading.abort();
    this.state = 'waiting';
    // Attributes that are set in the same task count as a single change.
    queueMicrotask(() => this.load());
  }

  /** The preset with the numbers and the hand that attributes give. @throws Error if one is wrong */
  private async readLook(signal: AbortSignal): Promise<HatchingPreset> {
    const preset = readPreset(this.getAttribute('preset'));
    const own: Record<string, number | Hand> = {};
    // Its one picture follows the light, which visitors turn.
    const composition: Partial<HatchingCompositionOptions> & Record<string, unknown> = { exposure: 'auto' };
    for (const name of Object.keys(LOOK_NUMBERS) as LookNumber[]) {
      const value = readLookNumber(name, this.getAttribute(name));
      const { property, isOfComposition } = LOOK_NUMBERS[name];
      if (value !== undefined) (isOfComposition ? composition : own)[property] = value;
    }
    const address = readHand(this.getAttribute('hand'), preset);
    if (address) own.hand = await this.fetchHand(resolve(address), signal);
    return { ...preset, material: { ...preset.material, ...own, composition } };
  }

  private async fetchHand(address: string, signal: AbortSignal): Promise<Hand> {
    if (this.fetchedHand?.address !== address) this.fetchedHand = { address, hand: await loadHand(address, signal) };
    return this.fetchedHand.hand;
  }

  /** Draws the model, if that is waited for. The previous drawing stays until it is ready. */
  private async load(): Promise<void> {
    if (this.state !== 'waiting' || !this.isNear) return;
    this.state = 'loading';
    this.loading = new AbortController();
    const { signal } = this.loading;
    try {
      if (!this.src) {
        this.state = 'empty';
        this.clear();
        warnOfMissingSource(this.hadSource);
        return;
      }
      this.hadSource = true;
      readLight(this.getAttribute('light'));
      const preset = await this.readLook(signal);
      if (this.drawing && !this.isOutdated) await this.drawing.setPreset(preset, signal);
      else await this.loadModel(preset, signal);
      if (signal.aborted) return;
      this.state = 'drawn';
      this.say('');
      this.invalidate();
      this.dispatchEvent(new Event('load'));
    } catch (error) {
      if (signal.aborted) return;
      this.state = 'failed';
      this.fail(error as Error);
    }
  }

  private async loadModel(preset: HatchingPreset, signal: AbortSignal): Promise<void> {
    this.painter ??= SharedRenderer.acquire(this.onRestored);
    const folders = { draco: folderOf(this.dracoPath), ktx2: folderOf(this.ktx2Path) };
    const { renderer } = this.painter;
    const source = { address: resolve(this.src), variant: this.variant.trim(), folders, renderer };
    const drawing = await Drawing.load(source, preset, this.camera.trim(), signal, this.invalidate);
    if (signal.aborted) {
      drawing.dispose();
      return;
    }
    this.drawing?.dispose();
    this.drawing = drawing;
    this.isOutdated = false;
    this.showFirst(drawing);
  }

  /** Shows the first view of a new model and lights it, unless an attribute or a visitor has set the view or the light. */
  private showFirst(drawing: Drawing): void {
    const { light, eye } = this.arrangement;
    const before = this.home.light;
    const { isFirst } = this;
    this.firstEye = drawing.firstEye ?? EYE;
    if (isFirst) Object.assign(eye, this.firstEye);
    const aspect = this.clientWidth / this.clientHeight;
    // An element without a size will get one.
    this.suitingLight = drawing.lightFor(this.firstEye, aspect > 0 && aspect < Infinity ? aspect : 1);
    if (light.azimuth === before.azimuth && light.elevation === before.elevation) {
      Object.assign(light, this.home.light);
    }
  }

  /** Whether the view is still the first one. */
  private get isFirst(): boolean {
    const { eye, zoom } = this.arrangement;
    return zoom === 1 && eye.azimuth === this.firstEye.azimuth && eye.elevation === this.firstEye.elevation;
  }

  /** The initial arrangement, which the Home key restores. */
  private get home(): Arrangement {
    let light: Direction | undefined;
    try {
      light = readLight(this.getAttribute('light'));
    } catch {
      // The load reports the error.
    }
    return { light: { ...(light ?? this.suitingLight) }, eye: { ...this.firstEye }, zoom: 1 };
  }

  private showLight(): void {
    try {
      Object.assign(this.arrangement.light, readLight(this.getAttribute('light')) ?? this.suitingLight);
    } catch (error) {
      this.fail(error as Error);
      return;
    }
    this.say('');
    this.invalidate();
    // A wrong light may be the reason why loading failed.
    if (this.state === 'failed') this.requestDrawing();
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
    this.watching?.controls.setMode(mode);
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

  /** Requests a frame. Further calls before it is drawn have no effect. */
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
    const ratio = Math.min(devicePixelRatio, MAX_PIXEL_RATIO);
    const [width, height] = [this.clientWidth, this.clientHeight].map((size) => Math.round(size * ratio));
    if (width === 0 || height === 0) return;
    // Setting a size clears the canvas, even if it is the same.
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const { light, eye, zoom } = this.arrangement;
    drawing.arrange(light, eye, zoom, width / height, this.isFirst);
    if (!painter.paint(drawing, canvas, ratio)) return;
    canvas.dataset.drawn = '';
    this.image.hidden = true;
  };

  /** Frees everything. If the element is inserted into a page again, it loads again. */
  private release(): void {
    this.state = 'apart';
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.loading.abort();
    this.watching?.near.disconnect();
    this.watching?.resizes.disconnect();
    this.watching?.controls.dispose();
    this.clear();
    this.painter?.release(this.onRestored);
    this.watching = this.painter = undefined;
    this.isNear = false;
  }

  /** Removes the drawing. */
  private clear(): void {
    this.drawing?.dispose();
    this.drawing = undefined;
    delete this.canvas.dataset.drawn;
    // A size of 0 frees the memory of the canvas.
    Object.assign(this.canvas, { width: 0, height: 0 });
    this.say('');
    this.showPoster();
  }
}

// Each attribute has a property, in camel case.
for (const name of ATTRIBUTES) {
  Object.defineProperty(
    HatchedModelElement.prototype,
    name.replace(/-(.)/g, (_, letter) => letter.toUpperCase()),
    {
      get(this: HTMLElement) {
        return this.getAttribute(name) ?? '';
      },
      set(this: HTMLElement, value: unknown) {
        if (value === null || value === undefined || value === false) this.removeAttribute(name);
        else this.setAttribute(name, value === true ? '' : String(value));
      },
      enumerable: true,
      configurable: true,
    },
  );
}

const resolve = (address: string): string => new URL(address, document.baseURI).href;

/** The URL of a folder, with a slash at its end. */
const folderOf = (path: string): string | undefined => (path ? resolve(path.replace(/\/*$/, '/')) : undefined);
