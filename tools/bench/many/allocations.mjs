/**
 * The bytes that functions of the library allocated, and what these called, by the name of the function and its file.
 *
 * @param {{ head: object }} profile - of V8's sampling heap profiler, with what was collected meanwhile
 * @returns {Map<string, number>}
 */
export function allocations({ head }) {
  const bytes = new Map();
  const visit = ({ callFrame, selfSize, children }, ours) => {
    const place = isOurs(callFrame) ? placeOf(callFrame) : ours;
    if (place !== null && selfSize > 0) bytes.set(place, (bytes.get(place) ?? 0) + selfSize);
    for (const child of children) visit(child, place);
  };
  visit(head, null);
  return bytes;
}

/** Sampling options: fine enough for a hundred bytes a frame, garbage included. */
export const SAMPLING = {
  samplingInterval: 256,
  includeObjectsCollectedByMajorGC: true,
  includeObjectsCollectedByMinorGC: true,
};

const isOurs = ({ url }) => url.includes('/src/') && !url.includes('node_modules');
const placeOf = ({ functionName, url }) => `${functionName} ${url.split('/src/')[1].split('?')[0]}`;
