import type { HandStroke } from 'three-hatching';
import { element } from '../page/elements.js';
import { type PenSample, StrokeRecorder } from './StrokeRecorder.js';
import { SHEET, SWATCHES } from './swatches.js';

/** The radius of the rubber, in millimetres. */
const RUBBER = 1.2;
/** The bit of a pen's eraser in `buttons`. */
const PEN_RUBBER = 32;

export type SwatchTool = 'pen' | 'rubber';

/** Receives what is drawn on the sheet. */
export interface SwatchListener {
  /** A stroke was drawn. */
  drawn(stroke: HandStroke): void;
  /** The rubber is at this point of the sheet, in millimetres. */
  rubbed(x: number, y: number, radius: number): void;
}

/** The canvas on which a hand is drawn, with mouse, pen or finger, in three fields from light to dark. */
export class SwatchCanvas {
  readonly element: HTMLElement;
  tool: SwatchTool = 'pen';
  /** The width of the pen at half pressure, in millimetres. */
  penWidth = 0.4;
  private readonly canvas = element('canvas', { className: 'hand-canvas' });
  private readonly recorder = new StrokeRecorder(() => this.penWidth);
  private strokes: readonly HandStroke[] = [];
  /** The pointer that rubs, if any. */
  private rubbing: number | undefined;
  /** The latest pressure of the drawing pointer. */
  private pressure = 0;
  /** The number of painted points of the stroke in progress. */
  private painted = 0;

  constructor(private readonly listener: SwatchListener) {
    const { canvas } = this;
    canvas.setAttribute('role', 'img');
    const labels = SWATCHES.map(({ label, darkness }) => {
      const patch = element('i', { className: 'hand-tone' });
      patch.style.opacity = String(darkness);
      return element('span', {}, element('b', { className: 'hand-label' }, label, patch));
    });
    const guides = element('div', { className: 'hand-guides' }, ...labels);
    guides.setAttribute('aria-hidden', 'true');
    this.element = element('div', { className: 'hand-swatches' }, canvas, guides);
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.moved(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', (event) => this.cancelled(event));
    // A long press of a finger or a pen must not open the browser's menu.
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    new ResizeObserver(() => this.paint()).observe(canvas);
  }

  /** Shows strokes instead of the previous ones. @param label accessible description */
  show(strokes: readonly HandStroke[], label: string): void {
    this.strokes = strokes;
    this.canvas.setAttribute('aria-label', label);
    this.paint();
  }

  /** Repaints everything, also after a change of size or colours. */
  paint(): void {
    const { canvas, strokes } = this;
    const context = canvas.getContext('2d');
    const width = Math.round(canvas.clientWidth * devicePixelRatio);
    if (!context || width === 0) return;
    canvas.width = width;
    canvas.height = Math.round((width * SHEET.height) / SHEET.width);
    const scale = width / SHEET.width;
    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.lineCap = 'round';
    context.strokeStyle = getComputedStyle(canvas).color;
    for (const stroke of strokes) paintStroke(context, stroke, 1);
    this.painted = 0;
    this.paintDrawn();
  }

  private down(event: PointerEvent): void {
    const { canvas, recorder, tool } = this;
    const isRubber = tool === 'rubber' || (event.buttons & PEN_RUBBER) !== 0;
    if (event.button > 0 && !isRubber) return;
    // Prevents focus changes and selection.
    event.preventDefault();
    if (isRubber) {
      if (this.rubbing !== undefined) return;
      this.rubbing = event.pointerId;
      this.rub(event);
    } else {
      this.pressure = event.pressure;
      const hasBegun = recorder.start(this.sample(event));
      // A second finger has cancelled the stroke.
      this.paint();
      if (!hasBegun) return;
    }
    canvas.setPointerCapture(event.pointerId);
  }

  private moved(event: PointerEvent): void {
    const { recorder } = this;
    if (event.pointerId === this.rubbing) this.rub(event);
    if (!recorder.isDrawing(event.pointerId)) return;
    // A pen is sampled more often than frames are drawn. Synthetic events have no list.
    const samples = event.getCoalescedEvents?.() ?? [];
    for (const one of samples.length > 0 ? samples : [event]) recorder.move(this.sample(one));
    this.pressure = event.pressure;
    this.paintDrawn();
  }

  private up(event: PointerEvent): void {
    if (event.pointerId === this.rubbing) this.rubbing = undefined;
    // The lifted pen has no pressure; the last segment keeps the previous one.
    this.recorder.move({ ...this.sample(event), pressure: this.pressure });
    const stroke = this.recorder.end(event.pointerId);
    if (stroke) this.listener.drawn(stroke);
    else this.paint();
  }

  private cancelled(event: PointerEvent): void {
    if (event.pointerId === this.rubbing) this.rubbing = undefined;
    this.recorder.cancel(event.pointerId);
    this.paint();
  }

  private rub(event: PointerEvent): void {
    const { x, y } = this.sample(event);
    this.listener.rubbed(x, y, RUBBER);
  }

  private paintDrawn(): void {
    const stroke = this.recorder.drawn;
    const context = this.canvas.getContext('2d');
    if (!stroke || !context) return;
    paintStroke(context, stroke, Math.max(1, this.painted));
    this.painted = stroke.widths.length;
  }

  private sample({
    pointerId,
    pointerType,
    clientX,
    clientY,
    pressure,
    tiltX,
    tiltY,
    timeStamp,
  }: PointerEvent): PenSample {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    return {
      pointerId,
      kind: pointerType === 'pen' || pointerType === 'touch' ? pointerType : 'mouse',
      x: ((clientX - left) / width) * SHEET.width,
      y: ((clientY - top) / height) * SHEET.height,
      pressure,
      tilt: tiltOf(tiltX, tiltY),
      time: timeStamp,
    };
  }
}

/** The angle between a pen and the normal of the sheet, from its tilts in two planes, in degrees. */
function tiltOf(tiltX: number, tiltY: number): number {
  const [x, y] = [tiltX, tiltY].map((degrees) => Math.tan((degrees * Math.PI) / 180));
  return (Math.atan(Math.hypot(x, y)) * 180) / Math.PI;
}

/** Paints the segments of a stroke, beginning with the one that ends at point `from`. */
function paintStroke(context: CanvasRenderingContext2D, { points, widths }: HandStroke, from: number): void {
  for (let i = from; i < widths.length; i++) {
    context.beginPath();
    context.lineWidth = (widths[i - 1] + widths[i]) / 2;
    context.moveTo(points[2 * i - 2], points[2 * i - 1]);
    context.lineTo(points[2 * i], points[2 * i + 1]);
    context.stroke();
  }
}
