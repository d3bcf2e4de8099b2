import { OUTLINE_CONSTANTS } from '../look/constants/outlineConstants.js';
import { vectorAt } from '../look/vectors.js';
import { asPhase } from '../mesh/phases.js';
import type { Bvh } from './Bvh.js';
import { backgroundPaths } from './backgroundPaths.js';
import type { Chain } from './Chain.js';
import { type CastingSphere, castingSphere, cullLit } from './cullLit.js';
import { type CutRun, cutRun, limitToSurface, refineEnds } from './cutRun.js';
import type { DrawnScene, EngravedSurface, OutlinedMesh } from './DrawnScene.js';
import { Engraver, type FamilyName } from './Engraver.js';
import { dashed, endHairlines } from './hairlines.js';
import type { LineTechnique } from './lineMarks.js';
import { DrawnOutlines } from './outlines/DrawnOutlines.js';
import { dropShortLines } from './outlines/dropShortLines.js';
import { loseEdges, type SeenOutline } from './outlines/loseEdges.js';
import { meetingOutlines } from './outlines/meetingOutlines.js';
import { outlineChains } from './outlines/outlineChains.js';
import { hiddenLook, outlinePieces, weighHidden } from './outlines/outlinePieces.js';
import { cutTest, outlineTest, weighByHierarchy } from './outlines/seenOutlines.js';
import type { Projection } from './Projection.js';
import { type Clip, isClipped } from './paint/PaintLook.js';
import { PlaceReader } from './paint/PlaceReader.js';
import { Translucency, TranslucentTone } from './paint/Translucency.js';
import { dashes, type LinePath } from './paths/LinePath.js';
import type { LayerName, PenPart } from './plot/pens.js';
import { readVertices, type Tracing } from './readVertices.js';
import { type Carrying, canBeEven, evenLines } from './streamlines/evenLines.js';
import { penChain, penPath } from './streamlines/penPaths.js';
import { subdivide } from './subdivide.js';
import { ToneReader, VertexTones } from './ToneReader.js';
import { seenSides, traceFamily } from './traceFamily.js';
import { type Run, type SeenTest, visibleRuns } from './visibleRuns.js';

const { DASH, FAINT, GAP } = OUTLINE_CONSTANTS;

const LAYER_OF: Readonly<Record<FamilyName, LayerName>> = {
  first: 'lines',
  crossB: 'crossing',
  crossC: 'crossing',
  thirdB: 'crossing',
  thirdC: 'crossing',
  shadowB: 'shadows',
  shadowC: 'shadows',
};

/** Height above a surface at which rays start, as a share of the size of the scene. */
const ABOVE = 1e-6;

/** A pen draws outlines behind see-through surfaces that leave more than this share of them visible. */
const LEAST_OF_OUTLINES = 0.2;

/** Shortest piece of outline that a pen draws unless it meets others, millimetres. */
const SHORTEST_ALONE = 2;

/** A path in a layer. */
interface LayeredPath {
  layer: PathLayer;
  path: LinePath;
}

/** A hidden line. dash: lengths of dashes and gaps, pixels; null for a line that is faint */
interface HiddenPath {
  layer: PathLayer;
  path: LinePath;
  dash: readonly [dash: number, gap: number] | null;
}

/** A part of a line that is visible to one share through see-through surfaces. */
interface FadedPart {
  faded: Chain;
  left: number;
  isLeft: SeenTest;
}

/** Outlines closer to each other than this count as one, millimetres. */
const SAME_LINE = 0.1;

/** The share of lines where surfaces meet in the time for outlines. */
const MEETING = 0.2;
/** The share of tracing in the time for a surface. */
const TRACED = 0.65;
/** The share of reading vertices in the time for tracing. */
const READING = 0.4;

/** A layer while it is drawn. */
export interface PathLayer {
  name: LayerName;
  ink: string;
  /** From 0 to 1. */
  opacity: number;
  /** The material or part that it belongs to, if these have layers of their own. */
  group: string;
  paths: LinePath[];
}

/** The width of the pen that draws a part of a drawing in an ink, pixels. */
export type PenWidths = (part: PenPart, ink: string) => number;

/** Draws the lines of a scene into layers, pixels of the picture. */
export class LineDrawer {
  readonly layers: PathLayer[] = [];
  segments = 0;
  /** Height above a surface at which rays start, world units. */
  readonly above: number;
  readonly translucency: Translucency;
  private casters: CastingSphere | null | undefined;

  /**
   * @param pens widths of the pens; null where widths are the tone
   * @param least the width of the thinnest line of a print, pixels; 0 for none
   * @param millimetre pixels per millimetre
   */
  constructor(
    private readonly scene: DrawnScene,
    private readonly pens: PenWidths | null,
    private readonly projection: Projection,
    private readonly bvh: Bvh,
    private readonly least = 0,
    private readonly millimetre = 1,
  ) {
    this.above = ABOVE * bvh.extent;
    this.translucency = new Translucency(
      bvh,
      projection,
      scene.translucent,
      this.above,
      translucentTones(scene, projection, bvh),
    );
  }

  *drawOutlines(): Generator<number, void, void> {
    const { pens, millimetre } = this;
    const { outlines: own } = this.scene;
    const seen: LayeredPath[] = [];
    const hidden: HiddenPath[] = [];
    const outlines = [...own, ...(yield* asPhase(meetingOutlines(own), 0, MEETING))];
    const partAt = (done: number): number => MEETING + ((1 - MEETING) * done) / outlines.length;
    for (const [i, outlined] of outlines.entries()) {
      const middle = i + (outlined.look.hidden === 'none' ? 1 : 0.5);
      yield* asPhase(this.drawSeen(outlined, seen), partAt(i), partAt(middle));
      if (middle === i + 1) continue;
      yield* asPhase(this.drawHidden(outlined, hidden), partAt(middle), partAt(i + 1));
    }
    const kept = pens ? this.joinedOutlines(seen, pens) : seen;
    // A pen would draw edges of parts that touch twice, and dashes on a visible line.
    const drawn = pens && new DrawnOutlines(SAME_LINE * millimetre);
    const once = (path: LinePath): LinePath[] => (drawn ? drawn.add(path) : [path]);
    for (const { layer, path } of kept) layer.paths.push(...once(path));
    for (const { layer, path, dash } of hidden)
      for (const piece of once(path)) layer.paths.push(...(dash ? dashes(piece, ...dash) : [piece]));
  }

  /** Leaves out short pieces of outlines that meet no others. */
  private joinedOutlines(seen: readonly LayeredPath[], pens: PenWidths): LayeredPath[] {
    const near = Math.max(...seen.map(({ layer }) => pens('outlines', layer.ink)), 0);
    return dropShortLines(seen, { shortest: SHORTEST_ALONE * this.millimetre, near });
  }

  private *drawSeen(
    { mesh, look, clip, ink, group }: OutlinedMesh,
    seen: LayeredPath[],
  ): Generator<number, void, void> {
    const { scene, projection, bvh, least, millimetre } = this;
    const pieces = yield* asPhase(outlinePieces(mesh, look), 0, 0.4);
    const pen = this.pens?.('outlines', ink) ?? 0;
    const joining = outlineChains(pieces, mesh, look, projection, scene.illumination, pen);
    const chains = yield* asPhase(joining, 0.4, 0.5);
    const parts: SeenOutline[] = [];
    for (const [i, chain] of chains.entries()) {
      const [from, to] = [0.5 + (0.5 * i) / chains.length, 0.5 + (0.5 * (i + 1)) / chains.length];
      this.segments += chain.count - 1;
      yield from;
      yield* asPhase(weighByHierarchy(chain, bvh, projection), from, (from + to) / 2);
      const isSeen = this.uncut(outlineTest(chain, bvh, projection), chain, clip);
      for (const { faded, isLeft } of yield* this.fadedParts(chain, isSeen)) {
        if (least > 0) endHairlines(faded, least);
        const runs = yield* asPhase(visibleRuns(faded, projection, isLeft), (from + to) / 2, to);
        parts.push({ chain: faded, runs });
      }
    }
    loseEdges(parts, { shortest: SHORTEST_ALONE * millimetre, leastHalf: least / 2 });
    for (const { chain, runs } of parts) {
      const layer = this.layerOf('outlines', ink, group);
      for (const { path } of this.cutRuns(chain, runs)) seen.push({ layer, path });
    }
  }

  /** Finds hidden outlines, for a layer of their own. */
  private *drawHidden(
    { mesh, look, clip, ink, group }: OutlinedMesh,
    found: HiddenPath[],
  ): Generator<number, void, void> {
    const { scene, projection, bvh } = this;
    const even = hiddenLook(look);
    const pieces = yield* asPhase(outlinePieces(mesh, even, true), 0, 0.4);
    weighHidden(pieces);
    const pen = this.pens?.('hidden', ink) ?? 0;
    const chains = yield* asPhase(outlineChains(pieces, mesh, even, projection, scene.illumination, pen), 0.4, 0.5);
    const layer = this.layerOf('hidden', ink, group, look.hidden === 'faint' ? FAINT : 1);
    const dash = look.hidden === 'dashed' ? ([DASH * look.width, GAP * look.width] as const) : null;
    for (const [i, chain] of chains.entries()) {
      const [from, to] = [0.5 + (0.5 * i) / chains.length, 0.5 + (0.5 * (i + 1)) / chains.length];
      this.segments += chain.count - 1;
      const isSeen = outlineTest(chain, bvh, projection, look.width / 2);
      const hidden = this.seenParts(
        chain,
        this.uncut((place) => !isSeen(place), chain, clip),
      );
      yield from;
      for (const { path } of yield* asPhase(hidden, from, to)) found.push({ layer, path, dash });
    }
  }

  /** A test that fails where the surface of an outline is cut out or clipped. */
  private uncut(isSeen: SeenTest, chain: Chain, clip: Clip | null): SeenTest {
    const isCut = cutTest(chain, this.bvh, this.projection);
    return clipped(isCut ? (place) => isSeen(place) && !isCut(place) : isSeen, clip);
  }

  /**
   * @param isEven whether the lines of a pen are placed on the sheet, where that is possible, instead of where the canvas has them
   * @param carrying the lines of the frame before that are taken over; null for a picture of its own
   */
  *drawSurfaces(isEven = false, carrying: Carrying | null = null): Generator<number, void, void> {
    const { surfaces } = this.scene;
    const placed = isEven ? surfaces.filter(canBeEven) : [];
    // A ground hides nothing, and its lines are placed for themselves.
    const groups = [
      ...this.byPen(placed.filter(({ hides }) => hides)),
      ...placed.filter(({ hides }) => !hides).map((one) => [one]),
    ];
    const isPlaced = new Set(placed);
    const others = surfaces.filter((surface) => !isPlaced.has(surface));
    let done = 0;
    for (const [k, group] of [...groups, ...others.map((one) => [one])].entries()) {
      const from = done / surfaces.length;
      done += group.length;
      if (group.length === 0) continue;
      const drawing = isPlaced.has(group[0]) ? this.drawEven(group, k, carrying) : this.drawSurface(group[0]);
      yield* asPhase(drawing, from, done / surfaces.length);
    }
  }

  /** Surfaces by the widths of their pens: lines of one width are placed together, those of woodcuts apart from all others. */
  private byPen(surfaces: readonly EngravedSurface[]): EngravedSurface[][] {
    const groups = new Map<string, EngravedSurface[]>();
    for (const surface of surfaces) {
      const isBlock = surface.engraved.technique === 'woodcut';
      const key = `${this.pens!('lines', surface.ink)} ${isBlock}`;
      groups.set(key, [...(groups.get(key) ?? []), surface]);
    }
    return [...groups.values()];
  }

  /** @param surfaces of one pen, and `group`, their place in the order of drawing */
  private *drawEven(
    surfaces: readonly EngravedSurface[],
    group: number,
    carrying: Carrying | null,
  ): Generator<number, void, void> {
    const { scene, projection, bvh, pens, millimetre, translucency } = this;
    const pen = pens!('lines', surfaces[0].ink);
    for (const surface of surfaces) yield* this.dropUnshaded(surface);
    if (surfaces.every(({ surface }) => surface.parents.length === 0)) return;
    const drawn = {
      scene,
      projection,
      bvh,
      translucency,
      pen: pen / millimetre,
      scale: 1 / millimetre,
      carrying,
      group,
    };
    const lines = yield* asPhase(evenLines(surfaces, drawn), 0, 0.9);
    for (const [i, line] of lines.entries()) {
      const { points, world, surface } = line;
      this.segments += points.length / 2 - 1;
      const layer = this.layerOf(line.layer, surface.ink, surface.group);
      if (world === null) {
        layer.paths.push(penPath(line, pen));
        continue;
      }
      yield 0.9 + (0.1 * i) / lines.length;
      for (const { path } of yield* this.seenParts(penChain(line, world, pen), () => true)) layer.paths.push(path);
    }
  }

  private *drawSurface(engraved: EngravedSurface): Generator<number, void, void> {
    const lines = yield* asPhase(this.tracedChains(engraved), 0, TRACED);
    for (const [i, { family, chain: line }] of lines.entries()) {
      this.segments += line.count - 1;
      const [from, to] = [i, i + 1].map((k) => TRACED + ((1 - TRACED) * k) / lines.length);
      yield from;
      const parts = yield* this.fadedParts(line, clipped(this.surfaceTest(line), engraved.clip));
      for (const { faded, left, isLeft } of parts) {
        const chain = this.asPressHolds(faded, engraved.engraved.technique);
        const isSeen =
          chain === faded ? isLeft : this.isLeftOf(chain, left, clipped(this.surfaceTest(chain), engraved.clip));
        const adding = this.addChain(
          this.layerOf(LAYER_OF[family], engraved.ink, engraved.group),
          chain,
          isSeen,
          engraved,
        );
        yield* asPhase(adding, from, to);
      }
    }
  }

  /** Splits a line by what it lies behind: for each share that is visible of any part of it, the line and a test for that share. */
  private *fadedParts(chain: Chain, isSeen: SeenTest): Generator<number, FadedPart[], void> {
    const { translucency, projection } = this;
    if (!translucency.isThere) return [{ faded: chain, left: 1, isLeft: isSeen }];
    if (this.pens) return [{ faded: chain, left: 1, isLeft: this.isLeftOfPen(chain, isSeen) }];
    const shares = new Set<number>();
    yield* visibleRuns(chain, projection, (place) => {
      const seen = isSeen(place);
      if (seen) shares.add(translucency.transmittance(place.world, chain.triangles[place.piece]));
      return seen;
    });
    return [...shares]
      .filter((left) => left > 0)
      .map((left) => ({
        faded: left === 1 ? chain : { ...chain, halves: this.fadedHalves(chain, left) },
        left,
        isLeft: this.isLeftOf(chain, left, isSeen),
      }));
  }

  private fadedHalves({ halves, world, triangles }: Chain, left: number): Float64Array {
    return halves.map((half, i) => {
      return left * half * this.translucency.deepening(vectorAt(world, 3 * i), triangles[i]);
    });
  }

  /** A test that passes where a pen draws a line behind see-through surfaces: all outlines, and so many other lines, each whole. */
  private isLeftOfPen({ triangles, outline, hash }: Chain, isSeen: SeenTest): SeenTest {
    const least = outline ? LEAST_OF_OUTLINES : hash;
    return (place) => isSeen(place) && this.translucency.transmittance(place.world, triangles[place.piece]) > least;
  }

  /** A test that passes where just this share of a line is visible. */
  private isLeftOf({ triangles }: Chain, left: number, isSeen: SeenTest): SeenTest {
    const { translucency } = this;
    if (!translucency.isThere) return isSeen;
    return (place) => isSeen(place) && translucency.transmittance(place.world, triangles[place.piece]) === left;
  }

  /** All lines on a surface, visible or not. Yields its progress. */
  *tracedChains(drawn: EngravedSurface): Generator<number, TracedLine[], void> {
    const { projection, bvh, pens, scene } = this;
    const { surface, look, turned, paint } = drawn;
    const pen = pens?.('lines', drawn.ink) ?? null;
    yield* this.dropUnshaded(drawn);
    yield* asPhase(subdivide(surface, projection), 0, 0.08);
    yield* this.dropUnshaded(drawn);
    const toneReader = new ToneReader(look, scene.illumination, bvh, projection);
    const sides = yield* asPhase(seenSides(surface, projection), 0.08, 0.1);
    const places = new PlaceReader(surface, paint, sides, projection);
    const tones = new VertexTones(toneReader);
    const lines: TracedLine[] = [];
    const all = [drawn, ...turned];
    for (const [i, { engraved, field }] of all.entries()) {
      const engraver = new Engraver(engraved, field, surface.viewToField, projection);
      const isTurned = (shadows: number) => turned.findIndex((one) => one.shadows === shadows) + 1 === i;
      const tracing = { surface, places, engraver, toneReader, projection, sides, pen };
      const tracingAll = tracedFamilies({ ...tracing, isDrawnIn: turned.length > 0 ? isTurned : null }, tones);
      const found = yield* asPhase(tracingAll, 0.1 + (0.9 * i) / all.length, 0.1 + (0.9 * (i + 1)) / all.length);
      for (const line of found) lines.push(line);
    }
    return lines;
  }

  private *dropUnshaded({ surface, look: { ground } }: EngravedSurface): Generator<number, void, void> {
    if (!ground) return;
    const { corners, sides, illumination } = this.scene;
    if (this.casters === undefined) this.casters = yield* castingSphere(corners, sides);
    yield* cullLit(surface, this.casters, illumination, ground);
  }

  *drawBackgrounds(): Generator<number, void, void> {
    for (const background of this.scene.backgrounds) {
      const pen = this.pens?.('background', background.ink) ?? null;
      const paths = yield* backgroundPaths(background, this.projection, this.bvh, pen);
      for (const path of paths) this.layerOf('background', background.ink, '').paths.push(path);
    }
  }

  /** A line of a print, nowhere thinner than a press can hold. */
  private asPressHolds(line: Chain, technique: LineTechnique): Chain {
    const { least } = this;
    // The black of a woodcut is drawn in adjacent cells, which may be thin.
    if (least === 0 || technique === 'woodcut') return line;
    if (technique === 'engraving') return dashed(line, least);
    // Strokes end instead of becoming dashes.
    endHairlines(line, least);
    return line;
  }

  private layerOf(name: LayerName, ink: string, group: string, opacity = 1): PathLayer {
    const known = this.layers.find(
      (one) => one.name === name && one.ink === ink && one.opacity === opacity && one.group === group,
    );
    if (known) return known;
    const layer: PathLayer = { name, ink, opacity, group, paths: [] };
    this.layers.push(layer);
    return layer;
  }

  /** A test for the visibility of a line on a surface. */
  surfaceTest({ triangles }: Chain): SeenTest {
    return ({ world, piece }) => {
      const { way, end } = this.projection.wayToEye(...world);
      return !this.bvh.isHidden(world, way, this.above / Math.hypot(...way), end, triangles[piece]);
    };
  }

  /** Adds the visible parts of a line on a surface. */
  private *addChain(
    layer: PathLayer,
    chain: Chain,
    isSeen: SeenTest,
    surface: EngravedSurface,
  ): Generator<number, void, void> {
    const { projection, bvh, pens } = this;
    for (const cut of yield* asPhase(this.seenParts(chain, isSeen), 0, 0.7)) {
      if (pens) layer.paths.push(cut.path);
      else {
        const finer = refineEnds(cut);
        yield* asPhase(limitToSurface(finer, bvh, projection, !surface.hides), 0.7, 1);
        layer.paths.push(finer.path);
      }
    }
  }

  private *seenParts(chain: Chain, isSeen: SeenTest): Generator<number, CutRun[], void> {
    return this.cutRuns(chain, yield* visibleRuns(chain, this.projection, isSeen));
  }

  private cutRuns(chain: Chain, runs: readonly Run[]): CutRun[] {
    const { projection, pens } = this;
    return runs.map((run) => cutRun(chain, run, projection, pens !== null)).filter(({ depths }) => depths.length >= 2);
  }
}

/** A line on a surface, and its family. */
interface TracedLine {
  family: FamilyName;
  chain: Chain;
}

/** The tones of see-through surfaces that are hatched themselves. To be read before surfaces are subdivided. */
function translucentTones(
  { surfaces, stippled, translucent, illumination }: DrawnScene,
  projection: Projection,
  bvh: Bvh,
): TranslucentTone[] {
  return [...surfaces, ...stippled]
    .filter(({ surface }) => translucent.some(({ first }) => first === surface.parents[0]))
    .map(
      ({ surface, look }) =>
        new TranslucentTone(surface, new ToneReader(look, illumination, bvh, projection), projection),
    );
}

function* tracedFamilies(tracing: Tracing, tones: VertexTones): Generator<number, TracedLine[], void> {
  const lines: TracedLine[] = [];
  const { families } = tracing.engraver;
  const read = yield* asPhase(readVertices(tracing, families), 0, READING);
  for (const [i, family] of families.entries()) {
    const [from, to] = [i, i + 1].map((k) => READING + ((1 - READING) * k) / families.length);
    for (const chain of yield* asPhase(traceFamily(tracing, family, read[i], tones), from, to))
      lines.push({ family, chain });
  }
  return lines;
}

/** A test that fails where clipping planes cut. */
const clipped = (isSeen: SeenTest, clip: Clip | null): SeenTest =>
  clip ? (place) => !isClipped(clip, place.world) && isSeen(place) : isSeen;
