/** What there is of each kind at the end of a lap, when the page shows the same as at the end of every other. */
export type Lap = Readonly<Record<string, number>>;

/** How much more there may be of each kind in the end: what ends by itself, and what a browser keeps for a while. */
const SLACK: Record<string, number> = {
  // What is made when it is first needed and then kept: shadow maps of each kind of light, the ground. A lap that leaves one
  // more each time is found out after some laps all the same.
  buffer: 4,
  texture: 4,
  program: 4,
  framebuffer: 4,
  vertexarray: 4,
  worker: 1,
  url: 5,
  sync: 2,
  // Of programs that are built and not drawn yet: three.js deletes them with the first frame. The ground keeps some such programs.
  shader: 4,
  listeners: 20,
  nodes: 60,
  // Of the arrays, in megabytes.
  arrays: 0.5,
  // Code that is compiled late, and what the browser measures of the page.
  heap: 8,
  // Freed memory is not given back at once.
  process: 250,
};

/**
 * What there is more of after the same thing was done many times, beyond what ends by itself.
 *
 * @returns a line for each kind
 */
export function grown(before: Lap, after: Lap): string[] {
  return Object.keys(before)
    .filter((kind) => !(after[kind] <= before[kind] + (SLACK[kind] ?? 0)))
    .map((kind) => `${kind} grows: ${before[kind]} before, ${after[kind]} after.`);
}

/** The laps that fill caches: of maps, programs and code. */
const WARM_UP = 2;

/**
 * What grows: the least in the last third of the laps is more than the greatest in the first. A single high lap is none, nor a
 * cache that fills up once.
 *
 * @returns a line for each kind
 */
export function judge(laps: readonly Lap[]): string[] {
  const counted = laps.slice(WARM_UP);
  if (counted.length < 3) return [`Only ${laps.length} laps: too few to tell. Give it more minutes.`];
  const third = Math.floor(counted.length / 3);
  const [early, late] = [counted.slice(0, third), counted.slice(-third)];
  const complaints: string[] = [];
  for (const kind of Object.keys(counted[0])) {
    const before = Math.max(...early.map((lap) => lap[kind]));
    const after = Math.min(...late.map((lap) => lap[kind]));
    if (after > before + (SLACK[kind] ?? 0)) complaints.push(`${kind} grows: ${before} at first, ${after} later.`);
    if (Number.isNaN(after)) complaints.push(`${kind} could not be counted.`);
  }
  return complaints;
}
