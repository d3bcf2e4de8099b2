/** The position and target of the camera, in units of the model's radius: numbers of single precision. */
export interface CameraView {
  position: [number, number, number];
  target: [number, number, number];
}
