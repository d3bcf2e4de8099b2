/** The series, by name in the results: three's material on the same geometry, and each technique on its best layout. */
const CURVES = {
  'phong corner': ['MeshPhongMaterial', '#888'],
  'adjacency corner': ['adjacency', '#1b5e9b'],
  'hatching indexed': ['hatching', '#b3541e'],
  'engraving indexed': ['engraving', '#2f7d32'],
};

/** Twice the time of Phong shading of the same geometry: "a ratio around 50%" of frame rates (Suarez et al., section 4). */
const RATIO_OF_THE_PAPER = 2;

const PAPER = { label: 'twice Phong, as in the paper', colour: '#888', dashes: ' stroke-dasharray="5 4"' };

const SIDE = 240;
const HEIGHT = 210;
const TRIANGLES = [4, 6];

/**
 * The counterpart of figure 15 of Suarez et al.: the time of a frame by number of triangles, one chart for each who draws.
 *
 * @param {readonly { title: string; models: Record<string, { triangles: number; drawn: Record<string, { ms: number }> }> }[]} runs
 */
export function drawFrameTimes(runs) {
  const width = 20 + runs.length * (SIDE + 60);
  const height = HEIGHT + 110;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" font-family="system-ui, sans-serif" font-size="12" role="img">
  <title>Time of a frame by number of triangles, beside twice the time of Phong shading</title>
<rect width="${width}" height="${height}" fill="#fff"/>
${runs.map((run, i) => chart(60 + i * (SIDE + 60), run)).join('\n')}
${legend(height - 14)}
</svg>
`;
}

function chart(left, { title, models }) {
  const rows = Object.values(models).sort((a, b) => a.triangles - b.triangles);
  const timesOf = (name) => rows.map(({ triangles, drawn }) => [triangles, drawn[name].ms]);
  const curves = Object.entries(CURVES).map(([name, [, colour]]) => ({ points: timesOf(name), colour }));
  const paper = timesOf('phong corner').map(([triangles, ms]) => [triangles, RATIO_OF_THE_PAPER * ms]);
  curves.push({ points: paper, ...PAPER });
  const logs = curves.flatMap(({ points }) => points.map(([, ms]) => Math.log10(ms)));
  const range = [Math.floor(Math.min(...logs)), Math.ceil(Math.max(...logs))];
  const x = (triangles) => left + (SIDE * (Math.log10(triangles) - TRIANGLES[0])) / (TRIANGLES[1] - TRIANGLES[0]);
  const y = (ms) => 40 + HEIGHT * (1 - (Math.log10(ms) - range[0]) / (range[1] - range[0]));
  const decades = Array.from({ length: range[1] - range[0] + 1 }, (_, i) => 10 ** (range[0] + i));
  return `<text x="${left}" y="24" font-weight="600">${title}: ms by triangles</text>
${decades.map((ms) => `<path d="M${left} ${y(ms)}h${SIDE}" stroke="#ddd"/><text x="${left - 6}" y="${y(ms) + 4}" text-anchor="end">${ms}</text>`).join('\n')}
${[1e4, 1e5, 1e6].map((count) => `<path d="M${x(count)} 40v${HEIGHT}" stroke="#eee"/><text x="${x(count)}" y="${HEIGHT + 58}" text-anchor="middle">${count < 1e6 ? `${count / 1000} k` : '1 M'}</text>`).join('\n')}
${curves.map(({ points, colour, dashes = '' }) => `<path d="M${points.map(([count, ms]) => `${x(count).toFixed(1)} ${y(ms).toFixed(1)}`).join('L')}" fill="none" stroke="${colour}" stroke-width="2"${dashes}/>`).join('\n')}`;
}

function legend(y) {
  const entries = [...Object.values(CURVES).map(([label, colour]) => ({ label, colour })), PAPER];
  let at = 60;
  return entries
    .map(({ label, colour, dashes = '' }) => {
      const left = at;
      at += 52 + 6.6 * label.length;
      return `<path d="M${left} ${y - 4}h22" stroke="${colour}" stroke-width="2"${dashes}/><text x="${left + 28}" y="${y}">${label}</text>`;
    })
    .join('\n');
}
