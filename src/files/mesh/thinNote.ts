/** A model with a radius of 1 and less surface than this is less than a pixel wide wherever it is seen. */
const LEAST_AREA = 0.002;

/** Says of a model with a radius of 1 that its triangles are slivers or dust, which strokes cannot show. */
export function thinNote(area: number): string[] {
  return area < LEAST_AREA ? ['its triangles are too thin to be hatched'] : [];
}
