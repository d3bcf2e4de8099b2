/** The kinds of lines, in the order in which they are drawn. */
export const LAYERS = ['outlines', 'lines', 'crossing', 'shadows', 'background', 'hidden'] as const;
export type LayerName = (typeof LAYERS)[number];

/** What can have a pen of its own width: outlines, hidden ones, lines on surfaces, the field behind a subject, and dots. */
export const PEN_PARTS = ['outlines', 'hidden', 'lines', 'background', 'dots'] as const;
export type PenPart = (typeof PEN_PARTS)[number];

/** What has a layer of its own: a kind of lines (its layer), an ink, a material or a part of the scene. */
export const PEN_LAYERS = ['layer', 'ink', 'material', 'part'] as const;
export type PenLayers = (typeof PEN_LAYERS)[number];

/** A pen of a plotter. */
export interface Pen {
  name: string;
  /** Such as `#1c1a17`. */
  ink: string;
  /** Millimetres. */
  width: number;
  /** Percent of the plotter's greatest speed; null for the plotter's own setting. */
  speed: number | null;
}

/** The pens of a drawing. */
export interface PenPlan {
  /** What has a layer of its own; `'pen'` where pens are listed. */
  layers: PenLayers | 'pen';
  /** The pens to which colours are matched; empty for a pen of any ink. */
  pens: readonly Pen[];
  /** The width of the pen that is not listed, millimetres. */
  widths: Readonly<Record<PenPart, number>>;
  /** The length after which a pen is filled again, millimetres; null for never. */
  refill: number | null;
}

/** The width of the pen that draws a part of a drawing in an ink, millimetres. */
export const penWidth = ({ pens, widths }: PenPlan, part: PenPart, ink: string): number =>
  pens.find((pen) => pen.ink === ink)?.width ?? widths[part];

/** The width of the thickest pen, millimetres. */
export const thickestPen = ({ pens, widths }: PenPlan): number =>
  Math.max(...(pens.length > 0 ? pens.map(({ width }) => width) : Object.values(widths)));

/** The part of a drawing that a layer belongs to. */
export function partOfLayer(name: LayerName): PenPart {
  return name === 'crossing' || name === 'shadows' ? 'lines' : name;
}
