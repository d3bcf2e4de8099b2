/**
 * The lens of a camera that differs from the page's. All of the picture that it frames is shown on any sheet. Numbers are of single
 * precision.
 */
export interface CameraLens {
  isOrthographic: boolean;
  /** Half the height of the picture: at distance 1, or at any distance if it is orthographic. */
  high: number;
  /** Width of the picture divided by its height; 0 if the file leaves it open. */
  aspect: number;
  /** The up direction of the picture. */
  up: [number, number, number];
}

/** Position and target of a camera, in units of the model's radius. Numbers are of single precision. */
export interface CameraView {
  position: [number, number, number];
  target: [number, number, number];
  /** Undefined for the page's own lens. */
  lens?: CameraLens | undefined;
}

/**
 * Half the height of a picture with the given aspect that contains all of a lens's own picture: at distance 1, or at any distance if it is
 * orthographic.
 */
export const halfHeightOf = ({ high, aspect: own }: CameraLens, aspect: number): number =>
  Math.max(high, (high * own) / aspect);
