/** The lens of a camera, where it is not that of the page. All of its own picture is on every sheet. Numbers of single precision. */
export interface CameraLens {
  isOrthographic: boolean;
  /** Half the height of its picture: at a distance of 1, or everywhere if it is orthographic. */
  high: number;
  /** How many times wider than high its picture is; 0 if that is left open. */
  aspect: number;
  /** What is up in its picture. */
  up: [number, number, number];
}

/** The position and target of the camera, in units of the model's radius: numbers of single precision. */
export interface CameraView {
  position: [number, number, number];
  target: [number, number, number];
  /** Undefined for the lens of the page. */
  lens?: CameraLens | undefined;
}

/** Half the height of a picture of any proportion that shows all of a lens's own: at a distance of 1, or everywhere if it is orthographic. */
export const halfHeightOf = ({ high, aspect: own }: CameraLens, aspect: number): number =>
  Math.max(high, (high * own) / aspect);
