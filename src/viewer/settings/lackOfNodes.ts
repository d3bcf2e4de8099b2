import type { Settings } from './settings.js';

/** Values of settings that materials of nodes do not draw, and what that is in words. */
const LACKS: readonly { [Key in keyof Settings]: [Key, readonly Settings[Key][], string] }[keyof Settings][] = [
  ['technique', ['adjacency', 'adjacencyCrisp', 'triangle'], 'this technique'],
  ['debugView', ['blendFactors', 'tone', 'frames'], 'views for checking'],
  ['background', ['on'], 'a hatched background'],
];

/** What of a drawing materials of nodes do not draw yet, in words; undefined if they draw all of it. */
export function lackOfNodes(settings: Settings): string | undefined {
  if (settings.compare !== 'none') return 'a comparison';
  return LACKS.find(([key, values]) => values.some((value) => value === settings[key]))?.[2];
}
