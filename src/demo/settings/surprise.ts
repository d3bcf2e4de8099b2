import { PRESET_NAMES } from './presetLabels.js';
import { presetLook, presetOf } from './presets.js';
import { SETTINGS, type Settings } from './settings.js';

/** Inks on papers that go together. */
const COLOURS = [
  ['#1c1a17', '#f7f3e8'],
  ['#1c1a17', '#ffffff'],
  ['#3a2416', '#f3e6cf'],
  ['#1d3a5f', '#eef1ee'],
  ['#7a2e1d', '#f4ead6'],
  ['#23402f', '#f2efe0'],
] as const;

/**
 * Another hand and another light for the same drawing. The same seed and settings give the same.
 *
 * @param seed a whole number
 */
export function surprise(settings: Settings, seed: number): Settings {
  const next = random(seed);
  const one = <Item>(items: readonly Item[]): Item => items[Math.floor(next() * items.length)];
  const within = (low: number, high: number): number => Math.round(low + (high - low) * next());
  const preset = one(PRESET_NAMES.filter((name) => name !== presetOf({ ...settings, boldness: 100, density: 100 })));
  const look = presetLook(preset);
  // White chalk stays on its board, and pencil on its paper.
  const [ink, paper] = look.paper === SETTINGS.paper.default ? one(COLOURS) : [look.ink, look.paper];
  const side = next() < 0.7 ? -1 : 1;
  return {
    ...settings,
    ...look,
    ink,
    paper,
    boldness: within(80, 130),
    density: within(90, 125),
    // From above and from the side, where light shows a form best.
    lightKind: 'directional',
    lightFollows: 'viewer',
    lightAzimuth: side * within(30, 80),
    lightElevation: within(18, 55),
    secondLight: 'none',
    shadows: 'on',
  };
}

/** Numbers in [0, 1), by mulberry32. */
function random(seed: number): () => number {
  let state = Math.imul(seed, 0x9e3779b1);
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), 1 | state);
    bits = (bits + Math.imul(bits ^ (bits >>> 7), 61 | bits)) ^ bits;
    return ((bits ^ (bits >>> 14)) >>> 0) / 2 ** 32;
  };
}
