const SECONDS = 20;
const SECONDS_PER_MEGABYTE = 0.5;

/**
 * The seconds that a reader may take without reporting progress. Some parsers report nothing before they are done, so larger files get
 * longer: even text is read at some megabytes per second.
 *
 * @param bytes of what is being read, unpacked
 */
export function readingTime(bytes: number): number {
  return SECONDS + (SECONDS_PER_MEGABYTE * bytes) / 2 ** 20;
}
