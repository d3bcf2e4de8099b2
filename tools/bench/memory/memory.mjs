import { peakOf } from '../peakOf.mjs';
import { figure, table } from '../table.mjs';

const SCALE = [
  { triangles: 1e6, technique: 'hatching', layout: 'indexed' },
  { triangles: 1e7, technique: 'hatching', layout: 'indexed' },
  { triangles: 1e6, technique: 'adjacency', layout: 'pull' },
  { triangles: 1e7, technique: 'adjacency', layout: 'pull' },
  { triangles: 1e6, technique: 'engraving', layout: 'indexed', form: true },
  { triangles: 4e6, technique: 'engraving', layout: 'indexed', form: true },
];
const STEADY = ['adjacency', 'hatching', 'engraving'].map((technique) => ({
  triangles: 5000,
  technique,
  layout: 'auto',
  outlines: true,
}));
const PLAN = { scale: SCALE, steady: STEADY, frames: 100 };
const QUICK = {
  scale: [{ triangles: 20_000, technique: 'hatching', layout: 'indexed' }],
  steady: STEADY.slice(1, 2),
  frames: 20,
};

/** Bytes between two allocations that are sampled: few enough for nearly every allocation. */
const SAMPLING_INTERVAL = 16;

/** The most memory that a bake takes, how long it blocks the page, and how much frames allocate. */
export const memory = {
  name: 'memory',
  perRasteriser: false,

  async run(browser, isQuick) {
    const { scale, steady, frames } = isQuick ? QUICK : PLAN;
    const baked = [];
    for (const plan of scale) baked.push({ ...plan, ...(await measureBake(browser, plan)) });
    const drawn = [];
    for (const plan of steady) drawn.push({ ...plan, ...(await measureGarbage(browser, plan, frames)) });
    return { frames, baked, drawn };
  },

  describe({ frames, baked, drawn }) {
    return `${table([
      [
        'layout',
        'triangles',
        'seconds',
        'million triangles/s',
        'peak of the tab, MB',
        'longest task, ms',
        'bytes a triangle',
        'of the source',
      ],
      ...baked.map(({ layout, form, triangles, seconds, peak, longestTask, bytes, sourceBytes }) => [
        nameOf({ layout, form }),
        triangles.toLocaleString('en'),
        figure(seconds),
        figure(triangles / seconds / 1e6),
        figure(peak / 2 ** 20),
        figure(longestTask),
        figure(bytes / triangles),
        figure(sourceBytes / triangles),
      ]),
    ])}
${describeGrowth(baked)}
Bytes that a frame leaves to the garbage collector, with outlines, while the camera turns; mean of ${frames} frames. Until V8 has optimised a
function, which takes thousands of frames, fractions that it reckons with are among them, of 12 to 16 bytes each.

${table([
  ['technique', 'by this library', 'by three.js', 'by what, of ours'],
  ...drawn.map(({ technique, ours, others, places }) => [technique, figure(ours), figure(others), places.join(', ')]),
])}`;
  },
};

const nameOf = ({ layout, form }) => (form ? `${layout}, form` : layout);

/** Growth of the peak from the smaller to the larger mesh of a layout: the browser's own share is the same with both. */
function describeGrowth(baked) {
  const layouts = [...new Set(baked.map(nameOf))];
  const parts = layouts.flatMap((layout) => {
    const [small, large] = baked.filter((row) => nameOf(row) === layout);
    if (!large) return [];
    const perTriangle = (name) => (large[name] - small[name]) / (large.triangles - small.triangles);
    return `${figure(perTriangle('peak') - perTriangle('sourceBytes'))} bytes with \`${layout}\``;
  });
  if (parts.length === 0) return '';
  return `
What the peak grows by for each further triangle, beyond its source and with the result: ${parts.join(', ')}.
`;
}

async function measureBake({ openMeasuring, rendererPids }, plan) {
  const before = new Set(await rendererPids());
  const { page, measure } = await openMeasuring();
  const own = (await rendererPids()).filter((pid) => !before.has(pid));
  try {
    const result = await measure('memory', plan);
    return { ...result, peak: Math.max(...own.map(peakOf)) };
  } finally {
    await page.close();
  }
}

async function measureGarbage({ openMeasuring }, plan, frames) {
  const { page, measure } = await openMeasuring();
  try {
    await measure('memory', plan);
    await measure('memoryFrames');
    const session = await page.context().newCDPSession(page);
    await session.send('HeapProfiler.startSampling', {
      samplingInterval: SAMPLING_INTERVAL,
      includeObjectsCollectedByMajorGC: true,
      includeObjectsCollectedByMinorGC: true,
    });
    await measure('memoryFrames', frames);
    const { profile } = await session.send('HeapProfiler.stopSampling');
    return summarise(profile.head, frames);
  } finally {
    await page.close();
  }
}

/** Adds up what was allocated by our files and by others, by frame. */
function summarise(head, frames) {
  let [ours, others] = [0, 0];
  const byPlace = {};
  const visit = ({ callFrame: { functionName, url }, selfSize, children }) => {
    if (url.includes('/src/')) {
      ours += selfSize;
      if (selfSize > 0) byPlace[functionName] = (byPlace[functionName] ?? 0) + selfSize;
    } else if (/three/.test(url)) others += selfSize;
    for (const child of children) visit(child);
  };
  visit(head);
  const places = Object.entries(byPlace)
    .sort((a, b) => b[1] - a[1])
    .slice(0, 4)
    .map(([name, size]) => `${name} ${figure(size / frames)}`);
  return { ours: ours / frames, others: others / frames, places };
}
