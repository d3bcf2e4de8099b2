import { Session } from 'node:inspector';
import { allocations, SAMPLING } from '../../tools/bench/many/allocations.mjs';

/** The bytes that functions of the library allocate in some work, by their names. */
function allocated(work: () => void): Map<string, number> {
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
function bytesPerFrame(bytes: ReadonlyMap<string, number>, frames: number): { sum: number; places: string } {
  const perFrame = [...bytes].map(([place, size]) => [place, Math.round(size / frames)] as const);
  return {
    sum: perFrame.reduce((total, [, size]) => total + size, 0),
    places: JSON.stringify(perFrame.filter(([, size]) => size > 0)),
  };
}

/** How often frames are looked at: on a busy machine the compiler is late, and until it is done every computed number is allocated. */
const LOOKS = 6;

/** The least that a number of frames leave, each. @param most what they may leave: less is not looked for */
export function leastPerFrame(draw: (frames: number) => void, frames: number, most: number) {
  let least = { sum: Infinity, places: '' };
  for (let look = 0; look < LOOKS && least.sum >= most; look++) {
    const found = bytesPerFrame(
      allocated(() => draw(frames)),
      frames,
    );
    if (found.sum < least.sum) least = found;
  }
  return least;
}
