import { Matrix4, Vector4 } from 'three';
import { element } from '../page/elements.js';
import type { Viewport } from '../viewport/Viewport.js';

/** The maximum number of triangles that are drawn of a part; of larger ones, an even sample. */
const MOST_TRIANGLES = 60_000;

/** The width of the line around a hidden part, in CSS pixels. */
const LINE = 1.5;

/**
 * Shows a part in the picture, through whatever is in front: as a negative of it, or as a line around it if it is hidden. Draws on a canvas
 * of its own, so that no frame is needed.
 */
export class PartHighlight {
  private readonly canvas = element('canvas', { className: 'part-highlight' });
  private part: number | undefined;

  constructor(private readonly viewport: Viewport) {
    this.canvas.setAttribute('aria-hidden', 'true');
    this.canvas.hidden = true;
    viewport.canvas.after(this.canvas);
    // The camera, the model or its pose has changed.
    viewport.frames.onFrame(() => this.draw());
  }

  /** @param part its index; undefined for none */
  show(part: number | undefined): void {
    if (part === this.part) return;
    this.part = part;
    this.canvas.hidden = part === undefined;
    this.draw();
  }

  private draw(): void {
    const { canvas, viewport, part } = this;
    if (part === undefined) return;
    const { clientWidth: width, clientHeight: height } = viewport.canvas;
    canvas.width = width * devicePixelRatio;
    canvas.height = height * devicePixelRatio;
    const { parts } = viewport.model ?? {};
    if (!parts) return;
    const { camera } = viewport;
    const toClip = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const context = canvas.getContext('2d')!;
    const shape = outlineOf(parts.trianglesOf(part, MOST_TRIANGLES), toClip, canvas.width, canvas.height);
    context.fillStyle = context.strokeStyle = '#fff';
    if (!parts.hidden.includes(part)) {
      context.fill(shape);
      return;
    }
    context.lineJoin = 'round';
    context.lineWidth = 2 * LINE * devicePixelRatio;
    context.stroke(shape);
    context.globalCompositeOperation = 'destination-out';
    context.fill(shape);
  }
}

/** One path of all triangles in front of the eye, all of which turn the same way, so that none cuts a hole into another. */
function outlineOf(triangles: Float32Array, toClip: Matrix4, width: number, height: number): Path2D {
  const path = new Path2D();
  const corner = new Vector4();
  const points = new Float64Array(6);
  for (let i = 0; i < triangles.length; i += 9) {
    let isInFront = true;
    for (let k = 0; k < 3; k++) {
      const at = i + 3 * k;
      corner.set(triangles[at], triangles[at + 1], triangles[at + 2], 1).applyMatrix4(toClip);
      isInFront &&= corner.w > 0;
      points[2 * k] = (0.5 + (0.5 * corner.x) / corner.w) * width;
      points[2 * k + 1] = (0.5 - (0.5 * corner.y) / corner.w) * height;
    }
    if (!isInFront) continue;
    const [ax, ay, bx, by, cx, cy] = points;
    const isTurned = (bx - ax) * (cy - ay) < (by - ay) * (cx - ax);
    path.moveTo(ax, ay);
    if (isTurned) {
      path.lineTo(cx, cy);
      path.lineTo(bx, by);
    } else {
      path.lineTo(bx, by);
      path.lineTo(cx, cy);
    }
    path.closePath();
  }
  return path;
}
