import { PRESET_NAMES } from './presetLabels.js';
import { presetLook, presetOf } from './presets.js';
import { Random } from './Random.js';
import { SETTINGS, type Settings } from './settings.js';

/** Matching pairs of ink and paper. */
const COLOURS = [
  ['#1c1a17', '#f7f3e8'],
  ['#1c1a17', '#ffffff'],
  ['#3a2416', '#f3e6cf'],
  ['#1d3a5f', '#eef1ee'],
  ['#7a2e1d', '#f4ead6'],
  ['#23402f', '#f2efe0'],
] as const;

/**
 * Random strokes and lights for the same subject, reproducible by seed and settings.
 *
 * @param seed an integer
 */
export function surprise(settings: Settings, seed: number): Settings {
  const random = new Random(Math.imul(seed, 0x9e3779b1));
  const within = (low: number, high: number): number => Math.round(low + (high - low) * random.next());
  const preset = random.pick(
    PRESET_NAMES.filter((name) => name !== presetOf({ ...settings, boldness: 100, density: 100 })),
  );
  const look = { ...settings, ...presetLook(preset) };
  // Looks with a paper of their own, such as chalk, keep their colours.
  const [ink, paper] = look.paper === SETTINGS.paper.default ? random.pick(COLOURS) : [look.ink, look.paper];
  const side = random.chance(0.7) ? -1 : 1;
  return {
    ...look,
    ink,
    paper,
    boldness: within(80, 130),
    density: within(90, 125),
    // From above and from the side, where light shows the form best.
    lightKind: 'directional',
    lightFollows: 'viewer',
    lightAzimuth: side * within(30, 80),
    lightElevation: within(18, 55),
    secondLight: 'none',
    shadows: 'on',
  };
}
