import type { DrawnScene } from './DrawnScene.js';

/** The phases of a drawing, in their order. */
const PHASES = ['building', 'outlines', 'surfaces', 'backgrounds', 'dots', 'finishing'] as const;
export type DrawingPhase = (typeof PHASES)[number];

/** From so many triangles on they take more of the time than lines do. */
const MANY = 300_000;

/** When each phase of a drawing begins and ends, as shares of the whole: about as long as it takes, so that progress rises evenly. */
export function drawingPhases(scene: DrawnScene): Record<DrawingPhase, readonly [from: number, to: number]> {
  const triangles = scene.sides.length;
  const many = triangles / (triangles + MANY);
  const lasts = (things: readonly unknown[], share: number): number => (things.length > 0 ? share : 0);
  const weights: Record<DrawingPhase, number> = {
    building: 0.04 + 0.16 * many,
    outlines: lasts(scene.outlines, 0.22),
    surfaces: lasts(scene.surfaces, 0.6),
    backgrounds: lasts(scene.backgrounds, 0.03),
    dots: lasts(scene.stippled, 0.6),
    finishing: 0.14 - 0.1 * many,
  };
  const sum = PHASES.reduce((total, phase) => total + weights[phase], 0);
  let end = 0;
  const spans = PHASES.map((phase) => {
    const start = end;
    end += weights[phase] / sum;
    return [phase, [start, Math.min(end, 1)]] as const;
  });
  return Object.fromEntries(spans) as Record<DrawingPhase, readonly [number, number]>;
}
