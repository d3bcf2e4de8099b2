/** What the JSON file of a saved map says. */
export interface MapDescription {
  format: typeof MAP_FORMAT;
  version: typeof MAP_VERSION;
  /** Texels per side of level 0. */
  size: number;
  /**
   * The file of every image, the lightest tone first: one name for a tone whose levels are to be made, or a list of its
   * levels, the finest first. All tones in the same way.
   */
  images: string[] | string[][];
  /** The files of the thresholds, the finest level first, where they were drawn. Else they are derived from the images. */
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
