/** Constants of metal that mirrors a room, for the processor and, as defines, for the shaders. */
export const METAL_CONSTANTS = {
  /** The share of the tone of a perfect mirror that the room decides; the rest is that of its shading. */
  MIRRORED: 0.85,
  /** Sine of the angle from the horizon within which light turns to dark. */
  HORIZON: 0.05,
  /** Light just below the horizon, and straight below, beside 1 above it. */
  ROOM: [0.06, 0.75],
  /** Sines of the angles below the horizon at which the floor begins to lighten, and at which it is lightest. */
  FLOOR: [0.3, 0.95],
} as const;
