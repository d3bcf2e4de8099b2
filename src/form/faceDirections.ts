/** A direction per face. Its sign means nothing until `cutForm` has combed the faces. */
export interface FaceDirections {
  /** Three floats per face: the unit direction across the lines, in which φ rises. */
  across: Float32Array<ArrayBuffer>;
  /** Three floats per face: the unit normal that `across` is perpendicular to, the mean of its fans' normals. */
  normals: Float32Array<ArrayBuffer>;
}
