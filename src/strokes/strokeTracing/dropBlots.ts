/**
 * Takes whole pieces of ink away that are too wide for strokes: blots, the dark around a sheet of paper.
 *
 * @param mask 1 for ink; changed in place
 * @param distances the distance of every pixel to paper
 * @param widest the greatest distance to paper that a stroke may have, in pixels
 */
export function dropBlots(mask: Uint8Array, distances: Float32Array, width: number, widest: number): void {
  const piece: number[] = [];
  for (let i = 0; i < distances.length; i++) {
    if (!mask[i] || distances[i] <= widest) continue;
    piece.push(i);
    mask[i] = 0;
    for (let pixel = piece.pop(); pixel !== undefined; pixel = piece.pop()) {
      for (const next of [pixel - 1, pixel + 1, pixel - width, pixel + width]) {
        if (!mask[next]) continue;
        mask[next] = 0;
        piece.push(next);
      }
    }
  }
}
