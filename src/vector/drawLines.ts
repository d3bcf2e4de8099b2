import { asPhase } from '../slices/asPhase.js';
import { Bvh } from './Bvh.js';
import type { Chain } from './Chain.js';
import { cutRun } from './cutRun.js';
import type { DrawingPlan, DrawnScene, EngravedSurface } from './DrawnScene.js';
import { Engraver, type FamilyName } from './Engraver.js';
import { finishPaths, type PathCounts } from './finishPaths.js';
import { holdBack } from './holdBack.js';
import type { LinePath } from './LinePath.js';
import { outlineChains } from './outlineChains.js';
import { outlinePieces } from './outlinePieces.js';
import { Projection } from './Projection.js';
import type { Placement } from './pathData.js';
import { outlineTest, weighByStanding } from './seenOutlines.js';
import { subdivide } from './subdivide.js';
import { Toner } from './Toner.js';
import { seenSides, traceFamily } from './traceFamily.js';
import { type SeenTest, visibleRuns } from './visibleRuns.js';
import { type SVGLayer, writeSVG } from './writeSVG.js';

/** A drawing, and what is counted in it. */
export interface LineDrawing extends PathCounts {
  svg: string;
  /** Pieces of lines that were traced, before any was hidden or left out. */
  segments: number;
}

/** The names of the layers, in their order. */
const LAYERS = ['outlines', 'engraved', 'crossing', 'shadows'] as const;
type LayerName = (typeof LAYERS)[number];

const LAYER_OF: Readonly<Record<FamilyName, LayerName>> = {
  first: 'engraved',
  crossB: 'crossing',
  crossC: 'crossing',
  shadowB: 'shadows',
  shadowC: 'shadows',
};

const MILLIMETRES_PER_INCH = 25.4;

/** Rays that leave a surface begin so far above it, as a share of the size of the scene. */
const ABOVE = 1e-6;

/** A layer while it is drawn. */
export interface PathLayer {
  name: LayerName;
  ink: string;
  paths: LinePath[];
}

/** Draws a scene as lines. Yields its progress from 0 to 1. */
export function* drawLines(scene: DrawnScene, plan: DrawingPlan): Generator<number, LineDrawing, void> {
  const { projection, placement } = placePicture(scene, plan);
  const bvh = yield* asPhase(Bvh.build(scene.corners, scene.sides), 0, 0.08);
  const drawer = new LineDrawer(scene, plan, projection, bvh);
  yield* asPhase(drawer.drawOutlines(), 0.08, 0.2);
  yield* asPhase(drawer.drawSurfaces(), 0.2, 0.9);
  const layers = LAYERS.flatMap((name) => drawer.layers.filter((layer) => layer.name === name));
  const { written, counts } = yield* asPhase(finishPaths(layers, plan, projection, placement), 0.9, 1);
  const named = layers.map(({ name, ink }, i): SVGLayer => {
    const isAlone = layers.filter((layer) => layer.name === name).length === 1;
    return { name: isAlone ? name : `${name} ${ink}`, ink, paths: written[i] };
  });
  return { svg: writeSVG(plan, named), segments: drawer.segments, ...counts };
}

/** The picture of the camera as large as it fits on the sheet within the margin, in the middle. */
function placePicture({ camera }: DrawnScene, plan: DrawingPlan): { projection: Projection; placement: Placement } {
  // The middle of a stroke keeps so far from the edge that all of it lies on the sheet.
  const margin = Math.max(plan.margin, (plan.pen ?? 0) / 2);
  const aspect = camera.projection[5] / camera.projection[0];
  const height = Math.min(plan.height - 2 * margin, (plan.width - 2 * margin) / aspect);
  const width = height * aspect;
  const scale = MILLIMETRES_PER_INCH / plan.dpi;
  return {
    projection: new Projection(camera, width / scale, height / scale),
    placement: { scale, left: (plan.width - width) / 2, top: (plan.height - height) / 2 },
  };
}

class LineDrawer {
  readonly layers: PathLayer[] = [];
  segments = 0;
  private readonly pen: number | null;
  private readonly above: number;

  constructor(
    private readonly scene: DrawnScene,
    plan: DrawingPlan,
    private readonly projection: Projection,
    private readonly bvh: Bvh,
  ) {
    this.pen = plan.pen === null ? null : (plan.pen * plan.dpi) / MILLIMETRES_PER_INCH;
    const [least, most] = scene.corners.reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [0, 0]);
    this.above = ABOVE * (most - least);
  }

  *drawOutlines(): Generator<number, void, void> {
    const { scene, projection, bvh } = this;
    for (const [i, { mesh, look, ink }] of scene.outlines.entries()) {
      const pieces = yield* asPhase(
        outlinePieces(mesh, look),
        i / scene.outlines.length,
        (i + 0.5) / scene.outlines.length,
      );
      const layer = this.layerOf('outlines', ink);
      for (const chain of outlineChains(pieces, mesh, look, projection, scene.meanLight)) {
        yield (i + 0.5) / scene.outlines.length;
        weighByStanding(chain, bvh, projection);
        this.addChain(layer, chain, outlineTest(chain, bvh, projection), false);
      }
    }
  }

  *drawSurfaces(): Generator<number, void, void> {
    const { surfaces } = this.scene;
    for (const [i, surface] of surfaces.entries())
      yield* asPhase(this.drawSurface(surface), i / surfaces.length, (i + 1) / surfaces.length);
  }

  private *drawSurface({ surface, engraved, field, look, ink }: EngravedSurface): Generator<number, void, void> {
    const { projection, bvh, pen, scene } = this;
    yield* asPhase(subdivide(surface, projection), 0, 0.1);
    const engraver = new Engraver(engraved, field, surface.viewToField, projection);
    const toner = new Toner(look, scene.illumination, bvh, projection);
    const sides = seenSides(surface, projection);
    const tracing = { surface, engraver, toner, projection, sides, pen };
    const { families } = engraver;
    for (const [i, family] of families.entries()) {
      const [from, to] = [0.1 + (0.9 * i) / families.length, 0.1 + (0.9 * (i + 1)) / families.length];
      const chains = yield* asPhase(traceFamily(tracing, family), from, 0.5 * (from + to));
      const layer = this.layerOf(LAYER_OF[family], ink);
      for (const [k, chain] of chains.entries()) {
        this.addChain(layer, chain, this.surfaceTest(chain), pen === null);
        yield 0.5 * (from + to) + (0.5 * (to - from) * (k + 1)) / chains.length;
      }
    }
  }

  private layerOf(name: LayerName, ink: string): PathLayer {
    const known = this.layers.find((one) => one.name === name && one.ink === ink);
    if (known) return known;
    const layer: PathLayer = { name, ink, paths: [] };
    this.layers.push(layer);
    return layer;
  }

  /** Whether a place on a line of a surface is seen. */
  private surfaceTest({ triangles }: Chain): SeenTest {
    return ({ world, piece }) => {
      const { way, end } = this.projection.wayToEye(...world);
      return !this.bvh.isHidden(world, way, this.above / Math.hypot(...way), end, triangles[piece]);
    };
  }

  /** Adds what is seen of a chain. isHeld: whether its sides must not reach beyond its surface. */
  private addChain({ paths }: PathLayer, chain: Chain, isSeen: SeenTest, isHeld: boolean): void {
    const { projection, bvh } = this;
    this.segments += chain.count - 1;
    for (const run of visibleRuns(chain, projection, isSeen)) {
      const cut = cutRun(chain, run, projection);
      if (cut.depths.length < 2) continue;
      if (isHeld) holdBack(cut, bvh, projection);
      paths.push(cut.path);
    }
  }
}
