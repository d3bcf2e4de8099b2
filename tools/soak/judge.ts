/** Number of objects of each kind at the end of a lap, when the page shows the same as at the end of every lap. */
export type Lap = Readonly<Record<string, number>>;

/** Allowed growth of each kind: some objects end by themselves, some a browser keeps for a while. */
const SLACK: Record<string, number> = {
  // Shadow maps of each kind of light and the ground are created when they are first needed, and kept. If every lap leaves one more,
  // some laps are enough to show it.
  buffer: 4,
  texture: 4,
  program: 4,
  framebuffer: 4,
  vertexarray: 4,
  worker: 1,
  url: 5,
  sync: 2,
  // Shaders of programs that are linked and not drawn with yet: three.js deletes them with the first frame. The ground keeps some such programs.
  shader: 4,
  listeners: 20,
  nodes: 60,
  // The typed arrays, in megabytes.
  arrays: 0.5,
  // Code that is compiled late, and measurements that the browser keeps of the page.
  heap: 8,
  // The system does not get freed memory back at once.
  process: 250,
};

/**
 * The kinds of which there are more after the same action was done many times, beyond their slack.
 *
 * @returns a line for each kind
 */
export function grown(before: Lap, after: Lap): string[] {
  return Object.keys(before)
    .filter((kind) => !(after[kind] <= before[kind] + (SLACK[kind] ?? 0)))
    .map((kind) => `${kind} grows: ${before[kind]} before, ${after[kind]} after.`);
}

/** The number of laps that fill the caches of maps, programs and code. */
const WARM_UP = 2;

/**
 * The kinds that grow: their least count in the last third of the laps is more than their greatest in the first. A single high lap is no
 * growth, nor is a cache that fills up once.
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
