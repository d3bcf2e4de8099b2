/** Where the camera stands and what it looks at, in units of the model's radius. */
export interface CameraView {
  position: [number, number, number];
  target: [number, number, number];
}
