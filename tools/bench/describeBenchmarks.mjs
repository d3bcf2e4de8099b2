import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { benchmarks } from './benchmarks.mjs';
import { drawFrameTimes } from './frame/drawFrameTimes.mjs';

/** The rasterisers, in the order of the document. */
const RASTERISERS = ['gpu', 'swiftshader', 'llvmpipe'];

const titles = {
  presets: 'Presets',
  frame: 'Frames',
  nodes: 'Frames of WebGPURenderer',
  many: 'Many things',
  media: 'Media',
  lines: 'Lines',
  shadows: 'Shadows',
  lineFields: 'What lines follow',
  bake: 'The bake by phase',
  form: 'Lines that follow the form',
  memory: 'Memory and garbage',
  occlusion: 'Ambient occlusion',
  upload: 'Upload',
  tam: 'Maps',
  firstPicture: 'To the first picture',
  drop: 'From drop to first frame',
  vector: 'Drawings as lines',
  detail: 'Large models',
};

/** The meaning of the numbers of each benchmark. */
const notes = {
  presets: `What users meet: every preset as \`applyHatching\` makes it, and \`default\`, what it makes where none is named, beside three's \`MeshPhongMaterial\` and
\`MeshLambertMaterial\` on the same meshes. A look is drawn in turn with both, every other turn backwards; ratios are taken within a turn, with their 95 % intervals.
In its shadow: with outlines and a shadow map that the model throws on itself, beside Phong with that map. On a ground: its shadow on a \`HatchingShadowMaterial\` as
well, beside three's \`ShadowMaterial\`. Script is that of \`renderer.render\` alone, on a canvas of 64 × 64 pixels, beyond Lambert's, by mesh and skin.`,
  frame: `Every technique is drawn on every layout that it can draw, and compared with three's \`MeshPhongMaterial\` on the geometry of the \`corner\` layout and
on the plain indexed one, and with \`adjacency\`. All are drawn in turn in one page, every other turn backwards. A frame is timed from its first command until
one of its pixels can be read. Ratios are taken within a turn; the tables have their medians with 95 % intervals, and the medians of times.

![Time of a frame by number of triangles, beside twice the time of Phong shading](benchmarks.svg)

This is figure 15 of Suarez et al. for this library, in time instead of frames per second. In the paper, hatching reached about half the frame rate of
Phong shading of the same geometry, on a Quadro FX 3800: the dashed line.`,
  nodes: `\`HatchingNodeMaterial\` beside three's \`MeshPhongMaterial\`, which \`WebGPURenderer\` draws as a \`MeshPhongNodeMaterial\`: same renderer, same geometry, in turn,
as above. The page's clock times it until a pixel can be read, the processor's part in a frame included.`,
  many: 'This is what a scene of many small things costs.',
  media: 'This is what the other techniques of strokes and lines cost, compared with `hatching`.',
  lines: 'This is what contours, borders and creases add to a frame, and to the main thread while the camera moves.',
  shadows: `This is what strokes that react to shadows cost, compared with strokes that shadows only darken, and what a ground that shows only shadows
adds to the frame. The shadow map is drawn once, before.`,
  lineFields: `Lines that follow the form or an axis, compared with those that follow the light. Geometries have the layout \`indexed\`; those drawn
along the form have the 24 bytes a vertex more. \`crossed\` asks for \`shadowStrokes: 'cross'\` too.`,
  bake: `These are the steps of the bake, on one thread of the page. \`check\` validates the mesh and measures its bounds, \`weld\` joins equal positions, \`pair\`
computes the normals of triangles and finds the twins of edges, \`creases\` cuts at the crease angle and at sharp edges, \`normals\` smooths the hatch normals,
and \`pack\` writes a layout. \`transfer\` passes the request to a worker and gets the result of the \`corner\` layout back.`,
  form: `These are the steps of baking the field of lines that follow the form, both families of lines, on one thread of the page. \`surface\` finds creases, smooths
normals and measures curvature, \`directions\` finds the field of lines, \`cut\` combs it, and \`lines\` finds the values whose levels are the lines. What every bake
does is not counted. Added vertices are those along the cut and around singular points.`,
  memory: `Tori without normals are baked in the library's worker and drawn once. The peak is the largest memory of the page's process, with worker and arrays,
as Linux reports it. The longest task is that of the main thread during the bake, 0 if none took 50 ms. Bytes are those of all arrays and
textures of the result, without outlines.`,
  occlusion: `\`bakeOcclusion\` of one model with the layout \`corner\` and the default number of directions, in the library's worker.`,
  upload: `This is how much longer a frame takes if the geometry must be uploaded to the GPU: the cost of \`bufferData\` and \`texImage2D\`.
Only one triangle is drawn.`,
  tam: '`TonalArtMap.generate` does this in a worker.',
  firstPicture: `A loaded model is hatched with \`hatching\`, outlines and the default map, each time in a new page. In turn: \`applyHatching\` without a map, the
map, \`compileAsync\`, the first frame. Together: \`applyHatching\` with \`renderer\` and \`camera\`, which does all but the frame side by side.

The built playground is opened with nothing fetched, compiled or started, over the loopback and over 10 Mbit/s with 40 ms of latency: \`context\` is when it has
its graphics context, \`read\` when its model is read, \`sketch\` when that was drawn first, in half the resolution and without outlines, \`whole\` when it was drawn
as it is, and \`complete\` when the last frame was drawn, with lines along the form and with dark hollows.`,
  drop: `A file is dropped on the built playground. \`read\` is the time until a worker has read it, \`first\` the time until the first frame that shows it can be read: as a placeholder if the bake takes
long, of more than 400,000 triangles a coarse copy; \`baked\` is the time until it is shown baked, with its lines. Cold is the first file of a page, warm the following ones. The longest task is that of the
page's main thread, 0 if none took 50 ms; the browser draws in a process of its own. All are medians with their 95 % intervals.`,
  vector: `A model is drawn as lines (SVG) in a worker: it is baked, and then drawn with lines by the light or along the form, with hard or soft shadows, or for a
single pen of a plotter.`,
  detail: `A large model is drawn by \`applyHatching\` with \`detail\`, which chooses the level that the view needs, and a smaller model without. Ratios are taken
within a turn. On the page a file of more than two million triangles is simplified while it is read. The first picture is of a coarse copy, the complete one of
the simplified model, baked. Flips on the way from the model tell whether levels pop: they should be no more than those of the whole model. The peak is the
largest memory of the page's process, with its workers, as Linux reports it. Where more processes ran than there are cores, only ratios, flips and the peak
are to be relied on.`,
};

/** Writes docs/research/benchmarks.md from the files in tools/bench/results. */
export function describeBenchmarks() {
  const sections = benchmarks.flatMap((benchmark) => {
    const runs = ['', ...RASTERISERS.map((rasteriser) => `.${rasteriser}`)].flatMap(
      (suffix) => read(`${benchmark.name}${suffix}.json`) ?? [],
    );
    if (runs.length === 0) return [];
    const parts = runs.map(({ environment, seconds, result }) => {
      const { renderer, cpu, cores, chromium, node, commit, load } = environment;
      const busy = load === undefined ? '' : `; ${load.toFixed(1)} processes ran in the minute before`;
      const drawn = benchmark.perRasteriser ? `Drawn by ${renderer}. ` : '';
      return `${benchmark.perRasteriser ? `### ${benchmark.name}, ${shortName(renderer)}\n\n` : ''}${drawn}${cpu}, ${cores} cores, Chromium ${chromium}, Node ${node.slice(1)}; commit ${commit}; took ${seconds} s${busy}.

${benchmark.describe(result)}`;
    });
    return [`## ${titles[benchmark.name]}\n\n${notes[benchmark.name]}\n\n${parts.join('\n\n')}`];
  });
  writeFileSync(docs('benchmarks.md'), `${[introduction, ...sections].join('\n\n')}\n`);
  const frames = RASTERISERS.flatMap((name) => read(`frame.${name}.json`) ?? []);
  const charts = frames.map(({ environment, result }) => ({ title: shortName(environment.renderer), ...result }));
  writeFileSync(docs('benchmarks.svg'), drawFrameTimes(charts));
}

const docs = (name) => fileURLToPath(new URL(`../../docs/research/${name}`, import.meta.url));

const introduction = `# Benchmarks

\`npm run bench\` writes this page from the files in \`tools/bench/results\`. SwiftShader and llvmpipe draw on the CPU, so their times say little about a GPU.
They are good for comparisons, and only of ratios from one run: on a busy machine times drift by a factor of two, but ratios within a turn hardly change. Where
a GPU is named (\`--rasteriser=gpu\`), it draws, and measures its own time (\`EXT_disjoint_timer_query_webgl2\`), without the time of the CPU. The H100 and the H200
are made for computing: only two of their 66 clusters can draw, so their times are those of a small card.

\`a [b, c]\` is a median a with its 95 % interval from b to c, computed from the ranks of the values, whatever their distribution.

\`npm run bench:compare -- OLD [NEW]\` builds the library of two commits (by default NEW is the working tree) and draws both in one page, in
turn. **Slower** means that the whole interval of the ratio new/old lies above 1.03, **faster** that it lies below 1/1.03; otherwise no difference can be
shown, and the result is the **same**. More turns (\`--turns=31\`) make the interval narrower.`;

function read(name) {
  const file = new URL(`./results/${name}`, import.meta.url);
  return existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : undefined;
}

/** The second name in `ANGLE (NVIDIA Corporation, NVIDIA H100/PCIe/SSE2, OpenGL ES 3.2)`. */
const shortName = (renderer) =>
  /swiftshader|llvmpipe/i.exec(renderer)?.[0] ?? /, ([^,/(]+)/.exec(renderer)?.[1] ?? renderer;
