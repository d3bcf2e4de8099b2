/** The numbers by which a hand is unsteady, for the processor and, as defines, for the shaders. */
export const HAND_CONSTANTS = {
  /** Units of the slow waves of a hand to a tile. */
  HAND_WAVES: 3.5,
  /** Other waves bend the slow ones: how far, how many there are to a unit and their phases. The numbers are without a pattern. */
  BENT_BY: 0.7,
  BENDS: 0.54,
  BEND_PHASES: [0.1, 0.67, 1.4],
  /** How many slow waves there are to a unit, and their phases. */
  SLOW_WAVES: 0.73,
  WAVE_PHASES: [0.35, 1.18, 1.66],

  /** How far lines stray, in tiles. */
  STRAY: 0.012,
  /** How much the pressure of a hand changes at most, and how much the widths of lines differ. */
  PRESSURE: 0.3,
  WIDTHS: 0.5,
} as const;
