/** A count in words, such as "3 shapes left out"; empty for a count of 0. */
export function counted(count: number, noun: string, rest: string): string {
  return count === 0 ? '' : `${count.toLocaleString('en')} ${noun}${count === 1 ? '' : 's'} ${rest}`;
}
