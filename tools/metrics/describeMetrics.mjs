import { flipsAt, isKept, requirements, toneError } from './requirements.mjs';

/**
 * @typedef {import('./page.js').ModelMetrics} ModelMetrics
 * @typedef {import('./flatTones.js').FlatTones} FlatTones
 * @typedef {import('./printedStrokes.js').PrintedStrokes} PrintedStrokes
 */

const colours = {
  hatching: '#0b0b0b',
  engraving: '#1e8449',
  'engraving, x': '#b9770e',
  'engraving, form': '#7d3c98',
  adjacency: '#c0392b',
  'adjacency, crisp': '#2471a3',
  triangle: '#8a8a8a',
};
const techniques = Object.keys(colours);

/** The position of the i-th entry of the legend: a short line and a name. */
const legendAt = (i) => techniques.slice(0, i).reduce((x, { length }) => x + 44 + 7 * length, 24);

const figure = (value) =>
  value === undefined || value === null
    ? ''
    : value !== 0 && Math.abs(value) < 0.001
      ? value.toExponential(0)
      : value.toFixed(3);

/** The page of the docs. @param {{ renderer: string, models: Record<string, ModelMetrics>, flatTones: FlatTones, printedStrokes: PrintedStrokes[] }} report */
export function describeMetrics({ renderer, models, flatTones, printedStrokes }) {
  return `# Measured strokes

Written by \`npm run metrics\`; drawn by ${renderer}. Every technique is measured on the same geometry, in the same run,
without antialiasing (\`edgePixels: 0\`). ${Object.keys(models).length} models, each scaled to a bounding radius of 1, lit from one side or evenly toned.

![Coherence of the strokes by number of triangles, and flips by turn of the light](metrics.svg)

\`engraving\` has its lines spaced on the screen (\`screenSpaceShare: 1\`), cut by the light; \`engraving, x\` has them cut by the x axis, and in
\`engraving, form\` they follow the form.

## Requirements

The worst value over all models, and the model it occurs on; **bold** where it is not what is required. Nothing is required of
\`adjacency\` and \`triangle\`, the techniques of Suarez et al.

${table(
  ['', 'required', ...techniques],
  requirements.map((requirement) => [
    requirement.name,
    describeLimits(requirement),
    ...techniques.map((technique) => {
      const found = requirement.worst(models, technique);
      if (!found) return '';
      const value = `${figure(found.value)} (${found.model})`;
      return technique in requirement.limits && !isKept(requirement, technique, found.value) ? `**${value}**` : value;
    }),
  ]),
)}

## Every model

- **grey**: share of surface pixels with a luminance between 0.2 and 0.8, in linear light. Engraved lines are measured with their
  soft edges, a pixel wide, which cannot be turned off.
- **jump**: mean and 95th percentile of the difference in luminance at the same points of an edge, shaded as part of one triangle
  and of the other. Edges that fold by more than 40° are left out.
- **kink**: median and 95th percentile of the angle in degrees by which strokes turn at an edge, with its triangles unfolded into a
  plane. Computed from the frames alone; \`adjacency\` blends what the frames draw, so both show. An engraved line is cut by a plane:
  it goes on from triangle to triangle without a gap, and bends by as much as the surface does. Lines that follow the form are not
  cut by planes, and have no such figure.
- **tone**: largest distance of mean ink from the requested tone, over tones 0.1, 0.25, 0.4, 0.6 and 0.8. Hatch images end at an
  ink of 0.95, thresholds at 1.
- **flips**: share of pixels that change between ink and paper as the light turns by 0.1°, 0.5°, 1° and 2°, divided by the share for
  two unrelated pictures. The stroke scale is chosen so that all techniques have the same stroke spacing, as far as octaves let
  them. On a sphere about its own origin the coordinates of Suarez et al. hardly change with the light (nor from place to place),
  so it is left out of the requirement. Lines cut by the light move as far as planes that turn about the middle of the model, and so change more than
  strokes; lines cut by an axis stay, and only their width would answer a change of tone.
- **popping**: flips between frames of a camera that comes 8 times nearer in 45 frames with \`screenSpaceShare: 1\`. Each point is
  looked up where the next frame shows it. The largest value over the median, then the median itself; then the same index for
  the mean change of luminance. Engraved lines have soft edges and come in as hair lines: flips count them at the moment they
  are half dark, which on \`engraving, x\` is the same moment for all, while nothing jumps.
- **spacing ±**: half the range of the distance in pixels between strokes during the same move, divided by its middle; then the
  same for 1, 2, 4 and 8 times as near alone.
- **coherence**: of the structure tensor, weighted by contrast, in the middle of a picture of 1000 pixels.
- **length**: how far one can go along a stroke without leaving the ink, at a tone of 0.25, in stroke spacings: the median over all
  ink, as a share of that of the map drawn on a wall. On the torus the middle of the picture holds places where strokes converge.

${Object.entries(models)
  .map(
    ([model, { triangles, techniques: measured }]) => `### ${model}, ${triangles.toLocaleString('en')} triangles

${table(
  ['', 'grey', 'jump', 'kink°', 'tone', 'flips', 'popping', 'spacing ±', 'coherence', 'length'],
  techniques.map((technique) => {
    const m = measured[technique];
    return [
      technique,
      figure(m.greyness),
      m.edgeJump ? `${figure(m.edgeJump.mean)}, ${figure(m.edgeJump.p95)}` : '',
      m.kink ? `${m.kink.median.toFixed(2)}, ${m.kink.p95.toFixed(1)}` : '',
      figure(toneError(m)),
      m.light ? m.light.flips.map(({ share }) => figure(share)).join(', ') : '',
      m.dolly
        ? `${m.dolly.popping.toFixed(2)} of ${figure(median(m.dolly.flips))}, ${m.dolly.luminancePopping.toFixed(2)}`
        : '',
      m.zoom ? `${figure(m.zoom.spread)}, ${figure(m.zoom.octaveSpread)}` : '',
      figure(m.coherence),
      m.strokeLength === undefined ? '' : figure(m.strokeLength),
    ];
  }),
)}
`,
  )
  .join('\n')}
${describeFlatTones(flatTones)}
${describePrintedStrokes(printedStrokes)}`;
}

/** @param {PrintedStrokes[]} printedStrokes */
function describePrintedStrokes(printedStrokes) {
  return `## Strokes in print

Presets that draw in strokes, at an even tone of 0.25, on a model that fills the width of a sheet of A5 at 300 dpi. A stroke is a piece of ink, joined at
sides and corners, of pixels that are covered by a quarter at least; its length is its extent along the major axis of its second moments. Strokes that reach the
silhouette are left out.

- **median**: the length of the middle stroke, and of the one that the middle of the ink belongs to, in millimetres.
- **crumbs**: the share of strokes shorter than 3 mm, and of the ink that lies in them. Most are what is left of a hair line where it fades.

${table(
  ['', 'model', 'strokes', 'median', 'by ink', 'crumbs', 'by ink'],
  printedStrokes.map(({ look, model, strokes, median, medianByInk, crumbs, crumbsByInk }) => [
    look,
    model,
    strokes,
    median.toFixed(1),
    medianByInk.toFixed(1),
    figure(crumbs),
    figure(crumbsByInk),
  ]),
)}
`;
}

/** Flat tones of the looks that are made of dots and grain. @param {FlatTones} flatTones */
function describeFlatTones(flatTones) {
  return `## Flat tones

Presets on a wall in even tones, 256 pixels wide, without their tone curves.

- **ink**: mean darkness. Stipple closes from half tone on, and is solid from 0.85 on.
- **dots** and **specks**: pieces of ink and pieces of paper on 10,000 pixels, each with the pixels of the middle one. Below half tone
  dots lie apart on one piece of paper; specks are what is left of it between dots that have grown together.
- **4 px** to **64 px**: the spectrum, as the standard deviation of the tone in octaves of wavelength, by the longest of each. Marbling
  is what there is in the last two.
- **coherence**: as above. That of dots is near 0; grain that runs along the strokes is nearer to 1.

${Object.entries(flatTones)
  .map(
    ([look, tones]) => `### ${look}

${table(
  ['tone', 'ink', 'dots', 'specks', '4 px', '8 px', '16 px', '32 px', '64 px', 'coherence'],
  tones.map(({ tone, ink, pieces, bands, coherence }) => [
    tone,
    figure(ink),
    `${pieces.ink.toFixed(0)} of ${pieces.inkArea}`,
    `${pieces.paper.toFixed(0)} of ${pieces.paperArea}`,
    ...bands.map(figure),
    Number.isFinite(coherence) ? figure(coherence) : '',
  ]),
)}
`,
  )
  .join('\n')}`;
}

/** Two small charts side by side. @param {Record<string, ModelMetrics>} models */
export function drawMetrics(models) {
  const dragons = Object.entries(models).filter(([name]) => name.startsWith('dragon'));
  const coherence = techniques.map((technique) => ({
    technique,
    points: dragons.map(([, { triangles, techniques: t }]) => [Math.log10(triangles), t[technique].coherence]),
  }));
  const lit = Object.entries(models).filter(([name, { techniques: t }]) => name !== 'sphere' && t.hatching.light);
  const turns = lit[0]?.[1].techniques.hatching.light.flips.map(({ degrees }) => degrees) ?? [];
  const flips = techniques.map((technique) => ({
    technique,
    points: turns.map((turn) => [turn, median(lit.map(([, { techniques: t }]) => flipsAt(t[technique], turn)))]),
  }));
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 300" font-family="system-ui, sans-serif" font-size="12" role="img">
  <title>Coherence of the strokes by number of triangles, and flips by turn of the light</title>
<rect width="720" height="300" fill="#fff"/>
${chart(
  50,
  'Coherence of strokes, by triangles of the dragon',
  coherence,
  [4, 6],
  [
    [4, '10 k'],
    [5, '100 k'],
    [6, '1 M'],
  ],
)}
${chart(
  410,
  'Flips, by degrees the light turns',
  flips,
  [0, 2],
  turns.map((turn) => [turn, `${turn}`]),
)}
${techniques
  .map(
    (technique, i) =>
      `<path d="M${legendAt(i)} 286h22" stroke="${colours[technique]}" stroke-width="2.5"/><text x="${legendAt(i) + 26}" y="290">${technique}</text>`,
  )
  .join('\n')}
</svg>
`;
}

/** The limits of a requirement, each with the techniques that share it. */
function describeLimits({ limits, atLeast }) {
  const sharing = (limit) => Object.keys(limits).filter((technique) => limits[technique] === limit);
  return [...new Set(Object.values(limits))]
    .map((limit) => `${atLeast ? '≥' : '≤'} ${figure(limit)} (${sharing(limit).join('; ')})`)
    .join(', ');
}

function chart(left, title, series, [from, to], ticks) {
  const [width, top, height] = [280, 40, 190];
  const x = (value) => (left + ((value - from) / (to - from)) * width).toFixed(1);
  const y = (value) => (top + (1 - value) * height).toFixed(1);
  return [
    `<text x="${left}" y="22" font-weight="600">${title}</text>`,
    ...[0, 0.25, 0.5, 0.75, 1].map(
      (value) =>
        `<path d="M${left} ${y(value)}h${width}" stroke="#ddd"/><text x="${left - 6}" y="${Number(y(value)) + 4}" text-anchor="end">${value}</text>`,
    ),
    ...ticks.map(
      ([value, label]) => `<text x="${x(value)}" y="${top + height + 18}" text-anchor="middle">${label}</text>`,
    ),
    ...series.map(
      ({ technique, points }) =>
        `<polyline points="${points.map(([a, b]) => `${x(a)},${y(b)}`).join(' ')}" fill="none" stroke="${colours[technique]}" stroke-width="2.5"/>`,
    ),
    ...series.flatMap(({ technique, points }) =>
      points.map(([a, b]) => `<circle cx="${x(a)}" cy="${y(b)}" r="3" fill="${colours[technique]}"/>`),
    ),
  ].join('\n');
}

function table(head, rows) {
  const line = (cells) => `| ${cells.join(' | ')} |`;
  return [line(head), line(head.map((_, i) => (i === 0 ? '---' : '--:'))), ...rows.map(line)].join('\n');
}

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];
