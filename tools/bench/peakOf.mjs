import { readFileSync } from 'node:fs';

/** The most memory that a process has had at once, in bytes, as Linux reports it. */
export function peakOf(pid) {
  const kilobytes = /VmHWM:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))?.[1];
  return 1024 * Number(kilobytes);
}
