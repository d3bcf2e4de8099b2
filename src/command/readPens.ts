import type { PlotterPen } from 'three-hatching/svg';
import { PEN_LAYERS, PEN_PARTS, type PenLayers, type PenPart } from '../vector/plot/pens.js';
import { shown, UsageError } from './readOptions.js';

/** The widths of pens, millimetres: one, or one for some of the parts of a drawing. */
export type PenWidths = number | Readonly<Partial<Record<PenPart, number>>>;

const THINNEST = 0.01;
const THICKEST = 20;

const widthOf = (text: string): number => {
  const width = /^(\d+\.?\d*|\.\d+)(mm)?$/i.test(text) ? Number.parseFloat(text) : Number.NaN;
  return width >= THINNEST && width <= THICKEST ? width : Number.NaN;
};

const listed = (names: readonly string[]): string => `${names.slice(0, -1).join(', ')} or ${names.at(-1)}`;

/**
 * Reads the widths of pens: a number of millimetres, and others after the names of parts, as `0.3, outlines 0.5`.
 *
 * @throws UsageError if the text is neither
 */
export function penWidths(text: string | undefined): PenWidths | undefined {
  if (text === undefined) return undefined;
  const entries = text.split(',').map((entry) => entry.trim().toLowerCase().split(/\s+/));
  const widths: Partial<Record<PenPart, number>> = {};
  let others: number | undefined;
  for (const [first, second, ...rest] of entries) {
    const part = PEN_PARTS.find((name) => name === first);
    const width = widthOf(part ? (second ?? '') : first);
    if (Number.isNaN(width) || rest.length > 0 || (!part && second !== undefined))
      throw new UsageError(
        `--pen is ${shown(text)}, but must be a number from ${THINNEST} to ${THICKEST}, or several as "0.3, outlines 0.5": for ${listed(PEN_PARTS)}.`,
      );
    if (part) widths[part] = width;
    else others = width;
  }
  if (Object.keys(widths).length === 0) return others;
  return others === undefined ? widths : { ...Object.fromEntries(PEN_PARTS.map((part) => [part, others])), ...widths };
}

/**
 * Reads what has a layer of its own, or the pens of a plotter, as `black 0.3, #d33 0.5 +S40`.
 *
 * @throws UsageError if the text is neither
 */
export function penLayers(text: string | undefined): PenLayers | readonly PlotterPen[] | undefined {
  if (text === undefined) return undefined;
  const word = text
    .trim()
    .toLowerCase()
    .replace(/^by\s+/, '');
  return PEN_LAYERS.find((name) => name === word) ?? text.split(',').map((entry) => penOf(entry.trim(), text));
}

function penOf(entry: string, text: string): PlotterPen {
  const [color, ...numbers] = entry.split(/\s+/);
  // The names of colours are known where the model is drawn.
  const isColor = /^(#[0-9a-f]{3}|#[0-9a-f]{6}|[a-z]+)$/i.test(color);
  const speeds = numbers.filter((one) => /^\+s\d+$/i.test(one)).map((one) => Number(one.slice(2)));
  const widths = numbers.filter((one) => !/^\+s\d+$/i.test(one)).map(widthOf);
  const isRead =
    isColor &&
    widths.length <= 1 &&
    speeds.length <= 1 &&
    !widths.some(Number.isNaN) &&
    speeds.every((one) => one >= 1 && one <= 100);
  if (!isRead)
    throw new UsageError(
      `--pens is ${shown(text)}, but must be ${listed(PEN_LAYERS)}, or colours with widths in millimetres, as "black 0.3, #d33 0.5", and speeds, as "red 0.5 +S40".`,
    );
  return { color: color.toLowerCase(), name: color, width: widths[0], speed: speeds[0] };
}

/**
 * Reads a length in metres, as `40m` or `40`.
 *
 * @throws UsageError if it is none
 */
export function metresOf(option: string, text: string | undefined): number | undefined {
  if (text === undefined) return undefined;
  const metres = /^(\d+\.?\d*|\.\d+)\s*m?$/i.test(text.trim()) ? Number.parseFloat(text) : Number.NaN;
  if (metres > 0) return metres;
  throw new UsageError(`--${option} is ${shown(text)}, but must be a number of metres above 0, as 40m.`);
}
