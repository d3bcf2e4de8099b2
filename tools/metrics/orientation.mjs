/** The greatest share of the area that may be left wrong, of models with 30 % of their patches or triangles turned. */
const MOST_WRONG = 0.005;
/** The longest time, as a share of the bake that the page does of the same mesh. */
const MOST_TIME = 0.25;

const percent = (share) => (share === undefined ? '' : `${(100 * share).toFixed(2)} %`);

/**
 * Measures how triangles that face the wrong way are turned, and prints a table. No browser is needed.
 *
 * @param server a Vite server, which loads the modules
 * @param names of models; all if empty
 * @returns what is not as required, one per line
 */
export async function printOrientation(server, names) {
  const { measureOrientation, timeOrientation } = await server.ssrLoadModule('/tools/metrics/measureOrientation.ts');
  const rows = await measureOrientation(names);
  console.log(
    '| model | kind | triangles | patches | right | inverted | 30 % of patches | 30 % of triangles | of a part | either side |',
  );
  console.log('| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |');
  for (const { model, kind, triangles, patches, ...row } of rows) {
    const shares = [row.right, row.inverted, row.ofPatches, row.ofTriangles, row.worstPart, row.eitherSide].map(
      percent,
    );
    console.log(`| ${[model, kind, triangles, patches, ...shares].join(' | ')} |`);
  }
  const missed = rows.flatMap(({ model, right, inverted = 0, ofPatches = 0, ofTriangles = 0 }) => [
    ...(right > 0 ? [`${model}: ${percent(right)} of it are turned though it is right`] : []),
    ...(Math.max(inverted, ofPatches, ofTriangles) > MOST_WRONG
      ? [`${model}: more than ${percent(MOST_WRONG)} wrong`]
      : []),
  ]);
  if (names.length > 0) return missed;
  for (const { mesh, triangles, orientation, bake } of timeOrientation()) {
    const share = orientation / bake;
    console.log(
      `${mesh}, ${triangles} triangles: ${orientation.toFixed(0)} ms of processor time, the bake ${bake.toFixed(0)} ms`,
    );
    if (share > MOST_TIME) missed.push(`${mesh}: ${percent(share)} of the bake`);
  }
  return missed;
}
