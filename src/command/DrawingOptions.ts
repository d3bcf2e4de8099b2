import type { Sheet } from '../vector/svg/sheetSizes.js';

/** A direction as degrees around the upright axis, from what faces the viewer to the right, and degrees above the horizon. */
export interface DirectionInDegrees {
  azimuth: number;
  elevation: number;
}

/** What the command line says of how models are drawn: plain data, which goes to the thread that draws. Lengths are in millimetres. */
export interface DrawingOptions {
  /** Undefined for that of the link, or of the playground at first. */
  preset: string | undefined;
  /** The hash of a link of the playground. */
  link: string | undefined;
  view: DirectionInDegrees | undefined;
  /** The name of a camera of the model, or its number from 1 on. */
  camera: string | undefined;
  /** How many times larger the picture is than one that the model fills. */
  zoom: number;
  orthographic: boolean;
  light: DirectionInDegrees | undefined;
  /** Whether the lights of the model are used, if it has any. */
  usesFileLights: boolean;
  shadows: boolean | undefined;
  /** The axis of the model that points up; undefined to find it. */
  up: 'y' | 'z' | 'x' | '-y' | '-z' | '-x' | undefined;
  /** The name of a variant of the model's materials, or its number from 1 on. */
  variant: string | undefined;
  /** The format of a model that neither its content nor its name tells, as an extension. */
  format: string | undefined;
  /** The name of a clip of the model, or its number from 1 on. */
  clip: string | undefined;
  /** So many pictures of a turn, or of the clip; undefined for one picture. */
  frames: number | undefined;
  kind: 'print' | 'pen';
  pen: number;
  sheet: Sheet;
  margin: number;
  dpi: number;
  /** `#rrggbb`, or undefined for none. */
  paper: string | undefined;
  order: 'travel' | 'drawn';
  /** Outlines behind surfaces; undefined as the look has them. */
  hidden: 'none' | 'dashed' | 'faint' | undefined;
  /** Seconds in which a file draws itself on a web page; undefined if it does not. */
  animate: number | undefined;
}
