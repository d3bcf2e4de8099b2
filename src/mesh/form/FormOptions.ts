/** How lines follow the form. Lengths are shares of the bounding radius, so that a scaled mesh is drawn alike. */
export interface FormOptions {
  /** The axis that lines run across where nothing else decides, in object space, of any length. Zero asks for no axis. */
  up: readonly [x: number, y: number, z: number];
  /**
   * The direction in object space from which the object is mostly seen, of any length. Singular points leave it, and lids are ruled
   * across it. Without one it is z, or −y where up is z. Zero asks for none.
   */
  front?: readonly [x: number, y: number, z: number] | undefined;
  /** The angle between the two families of lines, in radians in (0, π). */
  crossAngle: number;
  /** Relief finer than this share of the bounding radius does not turn lines. */
  smoothing: number;
  /** How far directions reach where curvature does not say any, as a share of the bounding radius. */
  reach: number;
}

/** What is used for options that are not given. */
export const FORM_DEFAULTS: FormOptions = {
  up: [0, 1, 0],
  crossAngle: Math.PI / 3,
  smoothing: 0.08,
  reach: 0.3,
};
