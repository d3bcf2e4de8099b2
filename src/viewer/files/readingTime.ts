const SECONDS = 20;
const SECONDS_PER_MEGABYTE = 0.5;

/**
 * The seconds after which a reader without progress is stopped. Some parsers report nothing before they finish, so larger files get longer:
 * even text is read at some megabytes per second.
 *
 * @param bytes of the unpacked input
 */
export function readingTime(bytes: number): number {
  return SECONDS + (SECONDS_PER_MEGABYTE * bytes) / 2 ** 20;
}
