/**
 * A field whose level sets are the lines that follow the form: φ, and φ₂ for the family that crosses it. Lines lie where φ is whole. φ has
 * one value per form vertex and is smooth over edges whose corners share their form vertices. Across the cut φ′ = ±φ + j, where j is a
 * multiple of four (of two for φ₂), so that lines continue, and of lines farther apart every fourth (second) one.
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
  /** The bounding radius of the baked mesh, in object units. */
  radius: number;
  statistics: FormStatistics;
}

/** The report of the bake on a form field. */
export interface FormStatistics {
  /** Points around which lines turn by half a turn or more, as few as the topology of the shape allows. */
  singularPoints: number;
  /** Form vertices beyond one per fan: along the cut and around singular points. */
  addedVertices: number;
}

/** Options of the form field. Lengths are shares of the bounding radius, so that a scaled mesh is drawn alike. */
export interface FormOptions {
  /** The axis that lines cross where nothing else decides, in object space, of any length. Zero: none. */
  up: readonly [x: number, y: number, z: number];
  /**
   * The direction in object space from which the object is mostly seen, of any length. Singular points avoid this side, and lids are ruled
   * across it. Default: z, or −y where up is z. Zero: none.
   */
  front?: readonly [x: number, y: number, z: number] | undefined;
  /** The angle between the two families of lines, in radians in (0, π). */
  crossAngle: number;
  /** Relief finer than this share of the bounding radius does not turn lines. */
  smoothing: number;
  /** How far directions spread over surface whose curvature shows none, as a share of the bounding radius. */
  reach: number;
}

/** The defaults. */
export const FORM_DEFAULTS: FormOptions = {
  up: [0, 1, 0],
  crossAngle: Math.PI / 3,
  smoothing: 0.08,
  reach: 0.3,
};
