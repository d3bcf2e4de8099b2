import { asPhase } from '../slices/asPhase.js';
import type { Bvh } from './Bvh.js';
import type { Chain } from './Chain.js';
import { cutRun } from './cutRun.js';
import type { DrawnScene, EngravedSurface, OutlinedMesh } from './DrawnScene.js';
import { Engraver, type FamilyName } from './Engraver.js';
import { holdBack } from './holdBack.js';
import type { LinePath } from './LinePath.js';
import { outlineChains } from './outlineChains.js';
import { outlinePieces } from './outlinePieces.js';
import type { Projection } from './Projection.js';
import { type Clip, isClipped } from './paint/Clip.js';
import { DetailReader } from './paint/DetailReader.js';
import { Painter } from './paint/Painter.js';
import { outlineTest, weighByStanding } from './seenOutlines.js';
import { subdivide } from './subdivide.js';
import { Toner } from './Toner.js';
import { seenSides, traceFamily } from './traceFamily.js';
import { type SeenTest, visibleRuns } from './visibleRuns.js';

/** The names of the layers, in their order. */
export const LAYERS = ['outlines', 'engraved', 'crossing', 'shadows'] as const;
export type LayerName = (typeof LAYERS)[number];

const LAYER_OF: Readonly<Record<FamilyName, LayerName>> = {
  first: 'engraved',
  crossB: 'crossing',
  crossC: 'crossing',
  shadowB: 'shadows',
  shadowC: 'shadows',
};

/** Rays that leave a surface begin so far above it, as a share of the size of the scene. */
const ABOVE = 1e-6;

/** A layer while it is drawn. */
export interface PathLayer {
  name: LayerName;
  ink: string;
  paths: LinePath[];
}

/** Draws the lines of a scene into layers, pixels of the picture. */
export class LineDrawer {
  readonly layers: PathLayer[] = [];
  segments = 0;
  private readonly above: number;

  /** @param pen its width, pixels; null where widths are the tone */
  constructor(
    private readonly scene: DrawnScene,
    private readonly pen: number | null,
    private readonly projection: Projection,
    private readonly bvh: Bvh,
  ) {
    this.above = ABOVE * scene.corners.reduce((size, x) => Math.max(size, Math.abs(x)), 0);
  }

  *drawOutlines(): Generator<number, void, void> {
    const { outlines } = this.scene;
    for (const [i, outlined] of outlines.entries())
      yield* asPhase(this.drawOutline(outlined), i / outlines.length, (i + 1) / outlines.length);
  }

  private *drawOutline({ mesh, look, clip, ink }: OutlinedMesh): Generator<number, void, void> {
    const { scene, projection, bvh } = this;
    const pieces = yield* asPhase(outlinePieces(mesh, look), 0, 0.4);
    const joining = outlineChains(pieces, mesh, look, projection, scene.meanLight);
    const chains = yield* asPhase(joining, 0.4, 0.5);
    for (const [i, chain] of chains.entries()) {
      yield 0.5 + (0.5 * i) / chains.length;
      weighByStanding(chain, bvh, projection);
      this.addChain(this.layerOf('outlines', ink), chain, clipped(outlineTest(chain, bvh, projection), clip), false);
    }
  }

  *drawSurfaces(): Generator<number, void, void> {
    const { surfaces } = this.scene;
    for (const [i, surface] of surfaces.entries())
      yield* asPhase(this.drawSurface(surface), i / surfaces.length, (i + 1) / surfaces.length);
  }

  private *drawSurface(engraved: EngravedSurface): Generator<number, void, void> {
    const lines = yield* asPhase(this.tracedChains(engraved), 0, 0.5);
    for (const [i, { family, chain }] of lines.entries()) {
      const isSeen = clipped(this.surfaceTest(chain), engraved.clip);
      this.addChain(this.layerOf(LAYER_OF[family], engraved.ink), chain, isSeen, this.pen === null);
      yield 0.5 + (0.5 * (i + 1)) / lines.length;
    }
  }

  /** All lines on a surface, seen or not. Yields its progress. */
  *tracedChains({
    surface,
    engraved,
    field,
    look,
    paint,
  }: EngravedSurface): Generator<number, { family: FamilyName; chain: Chain }[], void> {
    const { projection, bvh, pen, scene } = this;
    yield* asPhase(subdivide(surface, projection), 0, 0.08);
    const engraver = new Engraver(engraved, field, surface.viewToField, projection);
    const toner = new Toner(look, scene.illumination, bvh, projection);
    const sides = yield* asPhase(seenSides(surface, projection), 0.08, 0.1);
    const details = surface.details && new DetailReader(surface, surface.details);
    const painter = paint && surface.details && new Painter(paint, surface.details);
    const tracing = { surface, details, painter, engraver, toner, projection, sides, pen };
    const lines: { family: FamilyName; chain: Chain }[] = [];
    const step = 0.9 / engraver.families.length;
    for (const [i, family] of engraver.families.entries()) {
      const chains = yield* asPhase(traceFamily(tracing, family), 0.1 + step * i, 0.1 + step * (i + 1));
      for (const chain of chains) lines.push({ family, chain });
    }
    return lines;
  }

  private layerOf(name: LayerName, ink: string): PathLayer {
    const known = this.layers.find((one) => one.name === name && one.ink === ink);
    if (known) return known;
    const layer: PathLayer = { name, ink, paths: [] };
    this.layers.push(layer);
    return layer;
  }

  /** Whether a place on a line of a surface is seen. */
  surfaceTest({ triangles }: Chain): SeenTest {
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

/** A test that sees nothing of what clipping planes take away. */
const clipped = (isSeen: SeenTest, clip: Clip | null): SeenTest =>
  clip ? (place) => !isClipped(clip, place.world) && isSeen(place) : isSeen;
