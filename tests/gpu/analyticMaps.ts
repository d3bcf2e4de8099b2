/** Hatch images given by formulas, for comparing the material with the reference. Shared by the page and the tests. */
export const ANALYTIC_TONES = 8;

interface AnalyticMap {
  /** Texels per side of level 0. */
  size: number;
  levels: number;
  darkness(tone: number, u: number, v: number, level: number): number;
}

/** Darkness of the tone-th image; not linear in the tone, so that a wrong image shows. */
const darknessOfTone = (tone: number) => 0.9 * (tone / (ANALYTIC_TONES - 1)) ** 2;

export const analyticMaps = {
  /** Smooth in u and v and different along each, so that swapped, mirrored or shifted coordinates show. */
  smooth: {
    size: 256,
    levels: 1,
    darkness: (tone: number, u: number, v: number) =>
      darknessOfTone(tone) *
      (0.5 + 0.3 * Math.cos(2 * Math.PI * u) + 0.2 * Math.sin(2 * Math.PI * (2 * v + u)) * Math.cos(2 * Math.PI * v)),
  },
  /** One constant per tone, to test tone and blend weights alone. */
  constantPerTone: { size: 4, levels: 1, darkness: (tone: number) => darknessOfTone(tone) },
  /** One constant per tone and level. */
  constantPerLevel: {
    size: 256,
    levels: 5,
    darkness: (tone: number, _u: number, _v: number, level: number) => darknessOfTone(tone) * (1 - 0.18 * level),
  },
} satisfies Record<string, AnalyticMap>;

/** g of a threshold map, smooth and symmetric about the centre of the tile; half as many waves on each coarser level. */
export const analyticThreshold = {
  size: 256,
  levels: 3,
  field: (u: number, v: number, level: number) =>
    1.1 * Math.cos(2 * Math.PI * ((4 >> level) * v + (level + 1) * u)) +
    0.7 * Math.cos(2 * Math.PI * (3 - level) * u) * Math.cos(2 * Math.PI * v),
};

export type AnalyticMapName = keyof typeof analyticMaps;
