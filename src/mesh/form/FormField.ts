/**
 * What lines that follow the form are level sets of: φ, and φ₂ for the family that crosses it. Where φ is whole there is a line. φ
 * has one value per form vertex and is smooth over edges whose corners share their form vertices. Across the cut it becomes
 * ±φ + j with a j that is a multiple of four, and of two for φ₂, so that lines go on, and at a distance every fourth and every second.
 */
export interface FormField {
  /** The number of form vertices. */
  count: number;
  /** The form vertex of each corner. */
  ofCorner: Uint32Array<ArrayBuffer>;
  /** φ and φ₂ of each form vertex. */
  values: Float32Array<ArrayBuffer>;
  /** Three floats per form vertex: the gradient of φ in object space, in lines per object unit. */
  slopes: Float32Array<ArrayBuffer>;
  /** Three floats per form vertex: the gradient of φ₂. */
  crossings: Float32Array<ArrayBuffer>;
  /** The bounding radius of what it was baked for, in object units. */
  radius: number;
  statistics: FormStatistics;
}

/** What the bake reports about a form field. */
export interface FormStatistics {
  /** Points around which lines turn by half a turn or more: all that the shape demands, and no more. */
  singularPoints: number;
  /** Form vertices beyond one per fan: along the cut and around singular points. */
  addedVertices: number;
}

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
