import type { Sheet } from '../vector/svg/sheetSizes.js';

/** A direction in degrees: `azimuth` around the up axis, from the viewer's side to the right, and `elevation` above the horizon. */
export interface DirectionInDegrees {
  azimuth: number;
  elevation: number;
}

/** The options of the command line that control the drawing: plain data, sent to the drawing thread. Lengths are in millimetres. */
export interface DrawingOptions {
  /** Undefined for the preset of the link, or else of the playground's first view. */
  preset: string | undefined;
  /** The hash of a playground link. */
  link: string | undefined;
  view: DirectionInDegrees | undefined;
  /** The name of a camera of the model, or its number, counted from 1. */
  camera: string | undefined;
  /** Enlargement of the picture; at 1, the model fills it. */
  zoom: number;
  orthographic: boolean;
  light: DirectionInDegrees | undefined;
  /** Whether the model's own lights are used, if it has any. */
  usesFileLights: boolean;
  shadows: boolean | undefined;
  /** The up axis of the model; undefined to detect it. */
  up: 'y' | 'z' | 'x' | '-y' | '-z' | '-x' | undefined;
  /** The name of a material variant of the model, or its number, counted from 1. */
  variant: string | undefined;
  /** The format of the model as a file extension, where neither content nor name tells it. */
  format: string | undefined;
  /** The name of a clip of the model, or its number, counted from 1. */
  clip: string | undefined;
  /** The number of frames of a turn or of the clip; undefined for a single picture. */
  frames: number | undefined;
  kind: 'print' | 'pen';
  pen: number;
  sheet: Sheet;
  margin: number;
  dpi: number;
  /** `#rrggbb`, or undefined for none. */
  paper: string | undefined;
  order: 'travel' | 'drawn';
  /** How hidden outlines are drawn; undefined for the setting of the look. */
  hidden: 'none' | 'dashed' | 'faint' | undefined;
  /** Seconds in which the SVG draws itself on a web page; undefined for a still drawing. */
  animate: number | undefined;
}
