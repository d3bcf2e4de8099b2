import type { WrittenPath } from './finishPaths.js';

/** Shortest time in which a filled path appears, and in which a stroke does, seconds. */
const SHORTEST = 0.15;

/** The CSS of an animated drawing. With reduced motion it is shown as a whole. */
export function animationRules(isPen: boolean): string {
  const rule = 'animation:draw calc(var(--for)*1s) linear calc(var(--at)*1s) both';
  const frames = isPen
    ? '@keyframes draw{from{stroke-dashoffset:1;visibility:hidden}to{stroke-dashoffset:0}}'
    : '@keyframes draw{from{clip-path:inset(var(--from))}to{clip-path:inset(-9px)}}';
  const dashes = isPen ? 'stroke-dasharray:1 2;' : '';
  return `<style>${frames}@media (prefers-reduced-motion:no-preference){path{${dashes}${rule}}}</style>`;
}

/** Assigns each path its time. */
export class AnimationClock {
  private readonly perMillimetre: number;
  private at = 0;

  /**
   * @param seconds duration of the whole
   * @param drawn length of all paths, millimetres
   */
  constructor(
    seconds: number,
    drawn: number,
    private readonly isPen: boolean,
  ) {
    this.perMillimetre = drawn > 0 ? seconds / drawn : 0;
  }

  /** The attributes of the next path. */
  attributesOf({ length, way }: WrittenPath): string {
    const own = length * this.perMillimetre;
    const style = [`--at:${written(this.at)}`, `--for:${written(Math.max(own, SHORTEST))}`];
    if (!this.isPen) style.push(`--from:${coveredFrom(way)}`);
    this.at += own;
    return `${this.isPen ? ' pathLength="1"' : ''} style="${style.join(';')}"`;
  }
}

const written = (seconds: number): string => String(Number(seconds.toFixed(2)));

/** The insets (top, right, bottom, left) that cover a filled path before it appears, so that it grows along its direction. */
function coveredFrom([dx, dy]: readonly [number, number]): string {
  if (Math.abs(dx) >= Math.abs(dy)) return dx >= 0 ? '0 100% 0 0' : '0 0 0 100%';
  return dy >= 0 ? '0 0 100% 0' : '100% 0 0 0';
}
