import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { benchmarks } from './benchmarks.mjs';
import { drawFrameTimes } from './frame/drawFrameTimes.mjs';

/** The rasterisers, in the order of the document. */
const RASTERISERS = ['gpu', 'swiftshader', 'llvmpipe'];

const titles = {
  frame: 'Frames',
  media: 'Media',
  lines: 'Lines',
  shadows: 'Shadows',
  bake: 'The bake by phase',
  memory: 'Memory and garbage',
  occlusion: 'Ambient occlusion',
  upload: 'Upload',
  tam: 'Maps',
  drop: 'From drop to first frame',
};

/** What the numbers of each benchmark mean. */
const notes = {
  frame: `Every technique on every layout that it can draw, beside three's \`MeshPhongMaterial\` on the geometry of the \`corner\` layout and on the
plain indexed one, and beside \`adjacency\`. All are drawn in turn in one page, every other turn backwards; a frame is timed from its first command until a
pixel of it can be read. Ratios are taken within a turn, and their median is given with its 95 % interval; times are medians.

![Time of a frame by number of triangles, beside twice the time of Phong shading](benchmarks.svg)

This is figure 15 of Suarez et al. for this library, in time instead of frames per second. There, hatching reached about half the frame rate of
Phong shading of the same geometry, on a Quadro FX 3800: the dashed line.`,
  media: 'What media cost beside the ink of a pen. Pencil, charcoal and chalk are dry; a woodcut is carved.',
  lines: 'What contours, borders and creases add to a frame, and to the main thread while the camera moves.',
  shadows: `What strokes that know of shadows cost beside strokes that shadows only darken, and what a ground with nothing but shadows on it
adds to the frame. The shadow map is drawn once, before.`,
  bake: `The steps of the bake on one thread of the page. \`check\` validates and measures the bounds, \`weld\` joins equal positions, \`pair\` computes
the normals of triangles and finds the twins of edges, \`creases\` cuts at the crease angle and finds the edges of the form, \`normals\` smooths the hatch normals, \`pack\` writes a
layout; \`transfer\` hands the request to a worker and takes the result of the \`corner\` layout from it.`,
  memory: `Tori without normals are baked in the library's worker and drawn once. The peak is what the page's process has had at once, worker and arrays
included, as Linux counts it; the longest task is that of the main thread while the bake goes on, 0 where none took 50 ms. Bytes are those of all arrays and
textures of the result, without lines.`,
  occlusion: `\`bakeOcclusion\` of one model of the layout \`corner\` with the default number of directions, in the library's worker.`,
  upload: `How much longer a frame takes for which the geometry has to be given to the graphics card: what \`bufferData\` and \`texImage2D\`
cost. One triangle is drawn.`,
  tam: '`TonalArtMap.generate` does this in a worker.',
  drop: `A file is handed to the built playground; \`first\` is the time until the first frame that shows it can be read, with the normals it has
where the bake would take long, \`baked\` that until it is shown as baked, with its lines. Cold is the first file of a page, warm the following ones. The
longest task is that of the main thread, drawing included, 0 where none took 50 ms. All are medians with their 95 % interval. Runs from before a model was drawn
ahead of its bake have \`baked\` alone.`,
};

/** Writes docs/benchmarks.md from the files in tools/bench/results. */
export function describeBenchmarks() {
  const sections = benchmarks.flatMap((benchmark) => {
    const runs = ['', ...RASTERISERS.map((rasteriser) => `.${rasteriser}`)].flatMap(
      (suffix) => read(`${benchmark.name}${suffix}.json`) ?? [],
    );
    if (runs.length === 0) return [];
    const parts = runs.map(({ environment, seconds, result }) => {
      const { renderer, cpu, cores, chromium, node, commit } = environment;
      const drawn = benchmark.perRasteriser ? `Drawn by ${renderer}. ` : '';
      return `${benchmark.perRasteriser ? `### ${benchmark.name}, ${shortName(renderer)}\n\n` : ''}${drawn}${cpu}, ${cores} cores, Chromium ${chromium}, Node ${node.slice(1)}; commit ${commit}; took ${seconds} s.

${benchmark.describe(result)}`;
    });
    return [`## ${titles[benchmark.name]}\n\n${notes[benchmark.name]}\n\n${parts.join('\n\n')}`];
  });
  writeFileSync(docs('benchmarks.md'), `${[introduction, ...sections].join('\n\n')}\n`);
  const frames = RASTERISERS.flatMap((name) => read(`frame.${name}.json`) ?? []);
  const charts = frames.map(({ environment, result }) => ({ title: shortName(environment.renderer), ...result }));
  writeFileSync(docs('benchmarks.svg'), drawFrameTimes(charts));
}

const docs = (name) => fileURLToPath(new URL(`../../docs/${name}`, import.meta.url));

const introduction = `# Benchmarks

Written by \`npm run bench\` from the files in \`bench/results\`. Under SwiftShader and llvmpipe the processor draws, so times say little about a graphics card; what they
are good for is comparing, and there only ratios from one run count: on a busy machine times drift by a factor of two, ratios within a turn
hardly. Where a graphics card is named, \`--rasteriser=gpu\`, it draws and times itself (\`EXT_disjoint_timer_query_webgl2\`), without
what the processor takes. The H100 is a card for computing: two of its 66 clusters can draw, so its times are those of a small card.

\`a [b, c]\` is a median a with its 95 % interval from b to c, from the ranks of the values, whatever their distribution.

\`npm run bench:compare -- OLD [NEW]\` builds the library of two commits (NEW is the working tree if not given) and draws both in one page, in
turn. **Slower** means that the whole interval of the ratio new/old lies above 1.03, **faster** that it lies below 1/1.03; anything else
is the **same** as far as can be told. More turns (\`--turns=31\`) make the interval narrower.`;

function read(name) {
  const file = new URL(`./results/${name}`, import.meta.url);
  return existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : undefined;
}

/** The second name in `ANGLE (NVIDIA Corporation, NVIDIA H100/PCIe/SSE2, OpenGL ES 3.2)`. */
const shortName = (renderer) =>
  /swiftshader|llvmpipe/i.exec(renderer)?.[0] ?? /, ([^,/(]+)/.exec(renderer)?.[1] ?? renderer;
