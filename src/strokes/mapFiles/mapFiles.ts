/** The content of the JSON file of a saved map. */
export interface MapDescription {
  format: typeof MAP_FORMAT;
  version: typeof MAP_VERSION;
  /** Texels per side of level 0. */
  size: number;
  /** Width of the strokes in texels. Default: 2. */
  strokeTexels?: number;
  /**
   * The image files, lightest tone first: either one name per tone, from which the other levels are made, or a list of its levels, finest
   * first. All tones have the same form.
   */
  images: string[] | string[][];
  /** The files of the thresholds, finest level first. Without them, thresholds are derived from the images. */
  thresholds?: string[];
}

/** A file of a saved map. */
export interface MapFile {
  name: string;
  bytes: Uint8Array;
}

export const MAP_FORMAT = 'three-hatching tonal art map';
export const MAP_VERSION = 1;

/** The name of the JSON file. */
export const MAP_FILE = 'map.json';

/** Thresholds are multiples of this, so the 24 bits of an RGB pixel hold them exactly. */
export const THRESHOLD_STEP = 2 ** -24;
