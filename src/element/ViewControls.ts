import { MathUtils } from 'three';
import type { Controls, Direction } from './readAttributes.js';

/** Degrees per drag over the whole width of the canvas, and per press of an arrow key. */
const TURN = { drag: 180, key: 5 } as const;
/** The greatest elevation. Beyond the zenith left and right would be exchanged. */
const MAX_ELEVATION = 85;
const ZOOM = { least: 0.5, most: 6, key: 1.1, wheel: 0.001 } as const;
const SECOND_BUTTON = 2;

/** The steps of the arrow keys, to the right and upwards. */
const ARROWS: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
const ZOOM_KEYS: Readonly<Record<string, number>> = { '+': ZOOM.key, '=': ZOOM.key, '-': 1 / ZOOM.key };

/** The directions of light and eye, and the zoom. */
export interface Arrangement {
  light: Direction;
  eye: Direction;
  zoom: number;
}

/**
 * Turns the model or its light by mouse, touch and keys.
 *
 * A drag turns the model; with Shift or the second button it turns the light. Two fingers zoom. The wheel zooms if the canvas has the
 * focus; otherwise it scrolls the page. Arrow keys turn the model, with Shift the light; + and − zoom; Home resets everything.
 */
export class ViewControls {
  private mode: Controls = 'none';
  /** The position of each pressed pointer, and whether it turns the light. */
  private readonly pointers = new Map<number, { x: number; y: number; isForLight: boolean }>();
  private readonly listening = new AbortController();

  /**
   * @param home returns the arrangement that the Home key restores
   * @param onMove called when the arrangement has changed
   */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly arrangement: Arrangement,
    private readonly home: () => Arrangement,
    private readonly onMove: () => void,
  ) {
    const { signal } = this.listening;
    canvas.addEventListener('pointerdown', this.onPointerDown, { signal });
    canvas.addEventListener('pointermove', this.onPointerMove, { signal });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) {
      canvas.addEventListener(end, this.onPointerEnd, { signal });
    }
    canvas.addEventListener('contextmenu', this.onContextMenu, { signal });
    canvas.addEventListener('wheel', this.onWheel, { signal, passive: false });
    canvas.addEventListener('keydown', this.onKey, { signal });
  }

  /** Sets the object that a drag turns. */
  setMode(mode: Controls): void {
    this.mode = mode;
    this.pointers.clear();
    // A finger that moves up or down must still scroll the page.
    this.canvas.style.touchAction = mode === 'none' ? '' : 'pan-y';
  }

  private readonly onPointerDown = (event: PointerEvent): void => {
    const { pointerId, clientX: x, clientY: y, shiftKey, button } = event;
    if (this.mode === 'none' || (button !== 0 && button !== SECOND_BUTTON)) return;
    this.canvas.setPointerCapture(pointerId);
    this.pointers.set(pointerId, { x, y, isForLight: this.mode === 'light' || shiftKey || button === SECOND_BUTTON });
  };

  private readonly onPointerMove = ({ pointerId, clientX: x, clientY: y }: PointerEvent): void => {
    const pointer = this.pointers.get(pointerId);
    if (!pointer) return;
    const others = [...this.pointers.values()].filter((other) => other !== pointer);
    if (others.length === 0) {
      const scale = TURN.drag / this.canvas.clientWidth;
      this.turn((x - pointer.x) * scale, (pointer.y - y) * scale, pointer.isForLight);
    } else {
      const before = Math.hypot(pointer.x - others[0].x, pointer.y - others[0].y);
      if (before > 0) this.zoomBy(Math.hypot(x - others[0].x, y - others[0].y) / before);
    }
    Object.assign(pointer, { x, y });
  };

  private readonly onPointerEnd = ({ pointerId }: PointerEvent): void => {
    this.pointers.delete(pointerId);
  };

  private readonly onContextMenu = (event: Event): void => {
    if (this.mode !== 'none') event.preventDefault();
  };

  private readonly onWheel = (event: WheelEvent): void => {
    const root = this.canvas.getRootNode() as Document | ShadowRoot;
    if (this.mode === 'none' || root.activeElement !== this.canvas) return;
    event.preventDefault();
    this.zoomBy(Math.exp(-event.deltaY * ZOOM.wheel));
  };

  private readonly onKey = (event: KeyboardEvent): void => {
    const { key, shiftKey, ctrlKey, metaKey, altKey } = event;
    if (this.mode === 'none' || ctrlKey || metaKey || altKey) return;
    if (key in ARROWS) {
      const [right, up] = ARROWS[key];
      this.turn(right * TURN.key, up * TURN.key, shiftKey || this.mode === 'light');
    } else if (key in ZOOM_KEYS) this.zoomBy(ZOOM_KEYS[key]);
    else if (key === 'Home') this.goHome();
    else return;
    event.preventDefault();
  };

  /** @param right the angle by which the near side of the model, or the light, moves to the right, in degrees */
  private turn(right: number, up: number, isForLight: boolean): void {
    const { light, eye } = this.arrangement;
    const moved = isForLight ? light : eye;
    // The eye must move against the hand for the model to follow it.
    const sign = isForLight ? 1 : -1;
    moved.azimuth = MathUtils.euclideanModulo(moved.azimuth + sign * right + 180, 360) - 180;
    moved.elevation = MathUtils.clamp(moved.elevation + sign * up, -MAX_ELEVATION, MAX_ELEVATION);
    this.onMove();
  }

  private zoomBy(factor: number): void {
    this.arrangement.zoom = MathUtils.clamp(this.arrangement.zoom * factor, ZOOM.least, ZOOM.most);
    this.onMove();
  }

  private goHome(): void {
    const { light, eye, zoom } = this.home();
    Object.assign(this.arrangement.light, light);
    Object.assign(this.arrangement.eye, eye);
    this.arrangement.zoom = zoom;
    this.onMove();
  }

  dispose(): void {
    this.listening.abort();
    this.pointers.clear();
  }
}
