/** The largest number of workers at once. More of them would cost more memory than they save time. */
const MAX_WORKERS = 4;

/** The largest number of workers that a page uses: one per core, up to four. */
export function maxWorkers(): number {
  const cores = typeof navigator === 'undefined' ? 1 : navigator.hardwareConcurrency || 1;
  return Math.min(cores, MAX_WORKERS);
}
