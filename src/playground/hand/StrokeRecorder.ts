import type { HandStroke } from 'three-hatching';
import { SHEET, swatchAt } from './swatches.js';

/** A pointer sample, in millimetres on the sheet. */
export interface PenSample {
  pointerId: number;
  kind: 'mouse' | 'pen' | 'touch';
  x: number;
  y: number;
  /** From 0 to 1. Used for pens only: mice and most screens report a constant 0.5, 0 or 1. */
  pressure: number;
  /** The angle between the pointer and the normal of the sheet, in degrees. */
  tilt: number;
  /** In milliseconds. */
  time: number;
}

/** Samples closer than this to the previous one, in millimetres, are noise and left out. */
const LEAST_STEP = 0.15;
/** The maximum number of points per stroke: a scribble of three metres. */
const MOST_POINTS = 20_000;
/** Shorter strokes count as taps, in millimetres. */
const SHORTEST = 0.8;
/** Fingers and the palm are ignored for this long after pen input, in milliseconds. */
const PALM_MILLISECONDS = 1000;

/** Stroke width relative to the pen's, at no pressure and at full pressure. */
const LIGHTEST = 0.25;
const HEAVIEST = 1.9;
/** A pen tilted by more than this many degrees draws wider, up to this factor at full tilt. */
const TILTED_FROM = 35;
const TILTED_TO = 75;
const TILTED_WIDTH = 1.8;

/** Without pressure, the width depends on the speed: the factor at rest, and at this many millimetres per second. */
const AT_REST = 1.25;
const AT_SPEED = 0.55;
const FULL_SPEED = 250;
/** The distance over which the speed is averaged, in millimetres. */
const SPEED_REACH = 1.5;

/** A stroke in progress. */
interface Recording {
  pointerId: number;
  points: number[];
  widths: number[];
  /** The mean speed so far, in millimetres per second. */
  speed: number;
  length: number;
  last: PenSample;
}

/**
 * Turns pointer samples into strokes, one at a time. While a pen draws, and shortly after, fingers and the palm are ignored. A second
 * finger cancels the stroke of the first, because two fingers are another gesture.
 */
export class StrokeRecorder {
  private recording: Recording | undefined;
  private penTime = Number.NEGATIVE_INFINITY;
  /** The fingers on the sheet. */
  private readonly fingers = new Set<number>();

  /** @param penWidth the width of the pen at half pressure, in millimetres */
  constructor(private readonly penWidth: () => number) {}

  /** The points and widths of the stroke in progress. */
  get drawn(): HandStroke | undefined {
    const { recording } = this;
    return recording && recording.widths.length > 1 ? strokeOf(recording) : undefined;
  }

  /** Whether this pointer is drawing a stroke. */
  isDrawing(pointerId: number): boolean {
    return this.recording?.pointerId === pointerId;
  }

  /** @returns whether a stroke has begun */
  start(sample: PenSample): boolean {
    const { kind, time, pointerId } = sample;
    if (kind === 'pen') {
      this.penTime = time;
      // The palm may have begun a stroke before the pen came down.
      this.fingers.clear();
      this.recording = undefined;
    } else if (kind === 'touch') {
      if (time - this.penTime < PALM_MILLISECONDS) return false;
      this.fingers.add(pointerId);
      if (this.fingers.size > 1) {
        this.recording = undefined;
        return false;
      }
    }
    if (this.recording) return false;
    this.recording = { pointerId, points: [], widths: [], speed: 0, length: 0, last: sample };
    this.add(this.recording, sample);
    return true;
  }

  move(sample: PenSample): void {
    const { recording } = this;
    if (recording?.pointerId !== sample.pointerId) return;
    if (sample.kind === 'pen') this.penTime = sample.time;
    const { last } = recording;
    const step = Math.hypot(sample.x - last.x, sample.y - last.y);
    if (step < LEAST_STEP || recording.widths.length >= MOST_POINTS) return;
    const speed = (1000 * step) / Math.max(1, sample.time - last.time);
    const weight = recording.length === 0 ? 1 : Math.min(1, step / SPEED_REACH);
    recording.speed += weight * (speed - recording.speed);
    recording.length += step;
    recording.last = sample;
    this.add(recording, sample);
  }

  /** @returns the stroke, if the pointer has drawn more than a tap */
  end(pointerId: number): HandStroke | undefined {
    this.fingers.delete(pointerId);
    const { recording } = this;
    if (recording?.pointerId !== pointerId) return undefined;
    this.recording = undefined;
    return recording.length >= SHORTEST ? strokeOf(recording) : undefined;
  }

  /** Cancels the stroke, because the browser has cancelled the pointer. */
  cancel(pointerId: number): void {
    this.fingers.delete(pointerId);
    if (this.isDrawing(pointerId)) this.recording = undefined;
  }

  private add(recording: Recording, sample: PenSample): void {
    recording.points.push(
      thousandths(Math.min(SHEET.width, Math.max(0, sample.x))),
      thousandths(Math.min(SHEET.height, Math.max(0, sample.y))),
    );
    const share = sample.kind === 'pen' ? widthByPressure(sample) : widthBySpeed(recording.speed);
    recording.widths.push(thousandths(this.penWidth() * share));
  }
}

/** The width of a pen relative to half pressure and upright. */
function widthByPressure({ pressure, tilt }: PenSample): number {
  const tilted = Math.min(1, Math.max(0, (tilt - TILTED_FROM) / (TILTED_TO - TILTED_FROM)));
  const pressed = LIGHTEST + (HEAVIEST - LIGHTEST) * Math.min(1, Math.max(0, pressure));
  return pressed * (1 + (TILTED_WIDTH - 1) * tilted);
}

const widthBySpeed = (speed: number): number => AT_REST + (AT_SPEED - AT_REST) * Math.min(1, speed / FULL_SPEED);

const thousandths = (value: number): number => Math.round(1000 * value) / 1000;

const strokeOf = ({ points, widths }: Recording): HandStroke => ({
  points: [...points],
  widths: [...widths],
  swatch: swatchAt(middle(points)),
});

/** The height of a stroke's middle point, which determines its field. */
const middle = (points: readonly number[]): number => points[2 * Math.floor(points.length / 4) + 1];
