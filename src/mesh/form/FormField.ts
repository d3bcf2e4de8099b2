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
