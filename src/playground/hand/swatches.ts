import type { HandStroke, SwatchTone } from 'three-hatching';

/** A field of the sheet, in millimetres from its top left corner. */
export interface Swatch {
  tone: SwatchTone;
  label: string;
  /** Intended darkness, from 0 (paper) to 1. */
  darkness: number;
  top: number;
  bottom: number;
}

/** The fields, from the lightest at the top downwards. */
export const SWATCHES: readonly Swatch[] = [
  { tone: 'light', label: 'Light', darkness: 0.2, top: 0, bottom: 24 },
  { tone: 'middle', label: 'Middle', darkness: 0.45, top: 24, bottom: 48 },
  { tone: 'dark', label: 'Dark', darkness: 0.75, top: 48, bottom: 72 },
];

/** Size of the sheet, in millimetres. */
export const SHEET = { width: 76, height: 72 } as const;

/** The tone of the field at a height; that of the nearest field outside. */
export const swatchAt = (y: number): SwatchTone =>
  (SWATCHES.find(({ bottom }) => y < bottom) ?? SWATCHES[SWATCHES.length - 1]).tone;

/** The free margin of a field, in millimetres. */
const MARGIN = 1;

/** The bounding box of strokes. */
interface Bounds {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/**
 * Centres the strokes of each swatch in its field, and shrinks all by one factor if a swatch is too large. Returns the same array if the
 * strokes fit already.
 */
export function layOut(strokes: readonly HandStroke[]): readonly HandStroke[] {
  if (strokes.every(isInPlace)) return strokes;
  const found = SWATCHES.flatMap((swatch) => {
    const own = strokes.filter((stroke) => toneOf(stroke) === swatch.tone);
    return own.length > 0 ? [{ swatch, bounds: boundsOf(own) }] : [];
  });
  const scale = Math.min(
    1,
    ...found.flatMap(({ swatch, bounds: { left, top, right, bottom } }) => [
      (SHEET.width - 2 * MARGIN) / (right - left),
      (swatch.bottom - swatch.top - 2 * MARGIN) / (bottom - top),
    ]),
  );
  const moves = new Map<SwatchTone, readonly [x: number, y: number]>(
    found.map(({ swatch, bounds: { left, top, right, bottom } }) => [
      swatch.tone,
      [(SHEET.width - scale * (left + right)) / 2, (swatch.top + swatch.bottom - scale * (top + bottom)) / 2],
    ]),
  );
  return strokes.map((stroke) => {
    const tone = toneOf(stroke);
    const move = moves.get(tone)!;
    return {
      points: Array.from(stroke.points, (value, i) => thousandths(scale * value + move[i % 2])),
      widths: Array.from(stroke.widths, (width) => Math.max(0.001, thousandths(scale * width))),
      swatch: tone,
    };
  });
}

const toneOf = ({ swatch = 'middle' }: HandStroke): SwatchTone => swatch;

const thousandths = (value: number): number => Math.round(1000 * value) / 1000;

function isInPlace(stroke: HandStroke): boolean {
  const { left, top, right, bottom } = boundsOf([stroke]);
  const isOnSheet = left >= 0 && top >= 0 && right <= SHEET.width && bottom <= SHEET.height;
  const { points } = stroke;
  return isOnSheet && swatchAt(points[2 * Math.floor(points.length / 4) + 1]) === toneOf(stroke);
}

function boundsOf(strokes: readonly HandStroke[]): Bounds {
  const bounds = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
  for (const { points } of strokes) {
    for (let i = 0; i < points.length; i += 2) {
      bounds.left = Math.min(bounds.left, points[i]);
      bounds.right = Math.max(bounds.right, points[i]);
      bounds.top = Math.min(bounds.top, points[i + 1]);
      bounds.bottom = Math.max(bounds.bottom, points[i + 1]);
    }
  }
  return bounds;
}

/** Removes the strokes that a rubber at a point touches; returns the same array if it touches none. Lengths are in millimetres. */
export function eraseStrokes(
  strokes: readonly HandStroke[],
  x: number,
  y: number,
  radius: number,
): readonly HandStroke[] {
  const left = strokes.filter((stroke) => !touches(stroke, x, y, radius));
  return left.length === strokes.length ? strokes : left;
}

function touches({ points, widths }: HandStroke, x: number, y: number, radius: number): boolean {
  for (let i = 0; i + 1 < widths.length; i++) {
    const [fromX, fromY, toX, toY] = [points[2 * i], points[2 * i + 1], points[2 * i + 2], points[2 * i + 3]];
    const [dx, dy] = [toX - fromX, toY - fromY];
    const square = dx * dx + dy * dy;
    const along = square > 0 ? ((x - fromX) * dx + (y - fromY) * dy) / square : 0;
    const share = Math.min(1, Math.max(0, along));
    const width = widths[i] + share * (widths[i + 1] - widths[i]);
    if (Math.hypot(fromX + share * dx - x, fromY + share * dy - y) <= radius + width / 2) return true;
  }
  return false;
}
