import { Session } from 'node:inspector';
import { allocations, SAMPLING } from '../../tools/bench/many/allocations.mjs';

/** The bytes that functions of the library allocate in some work, by their names. */
export function allocated(work: () => void): Map<string, number> {
  const session = new Session();
  session.connect();
  let found = new Map<string, number>();
  session.post('HeapProfiler.startSampling', SAMPLING);
  work();
  session.post('HeapProfiler.stopSampling', (_, { profile }) => {
    found = allocations(profile);
  });
  session.disconnect();
  return found;
}

/** How much of that is left by each of a number of frames: by name, what leaves anything, and the sum. */
export function bytesPerFrame(bytes: ReadonlyMap<string, number>, frames: number): { sum: number; places: string } {
  const perFrame = [...bytes].map(([place, size]) => [place, Math.round(size / frames)] as const);
  return {
    sum: perFrame.reduce((total, [, size]) => total + size, 0),
    places: JSON.stringify(perFrame.filter(([, size]) => size > 0)),
  };
}
