/** The number of turns: with so many, a model is hardly wider between two of them than in one. */
const TURNS = 24;

/** The points of a model in all its turns about the upright axis. @param positions xyz of each point */
export function turnedOutlines(positions: ArrayLike<number>): Float32Array {
  const all = new Float32Array(TURNS * positions.length);
  for (let turn = 0; turn < TURNS; turn++) {
    const [cosine, sine] = [Math.cos((2 * Math.PI * turn) / TURNS), Math.sin((2 * Math.PI * turn) / TURNS)];
    for (let i = 0; i < positions.length; i += 3) {
      const [x, z] = [positions[i], positions[i + 2]];
      all.set([x * cosine + z * sine, positions[i + 1], z * cosine - x * sine], turn * positions.length + i);
    }
  }
  return all;
}
