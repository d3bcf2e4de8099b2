import { combined, dot, normalize, type Vec3 } from '../../look/vectors.js';
import { asPhase } from '../../mesh/phases.js';
import { type Chain, ChainBuilder, type OutlinePoint } from '../Chain.js';
import { fadedPlace, type Projection, transformed } from '../Projection.js';
import { outlineFadingAt } from '../shading/fading.js';
import { crowdedHalf, shadeWeight, wobbleAt } from '../shading/outlines.js';
import { meanLightAt } from '../shading/radiance.js';
import type { Illumination } from '../ToneReader.js';
import type { OutlineLook, OutlineMesh, OutlinePiece, PieceEnd } from './OutlineMesh.js';

/** Greatest angle between pieces that are joined. Radians, in space, since on the picture unrelated edges may be collinear. */
const SHARPEST = (40 * Math.PI) / 180;
/** Greatest distance between points of outlines, so that their weight can change along the way. Pixels. */
const LONGEST_PIECE = 6;
/** Pieces per step. */
const CHUNK = 256;

/**
 * Weighs pieces by the light, and joins them to chains. Yields its progress.
 *
 * @param pen width of the pen that draws all outlines, pixels; 0 where they have widths of their own
 */
export function* outlineChains(
  pieces: readonly OutlinePiece[],
  mesh: OutlineMesh,
  look: OutlineLook,
  projection: Projection,
  lights: Illumination,
  pen: number,
): Generator<number, Chain[], void> {
  for (const [i, piece] of pieces.entries()) {
    if (i % CHUNK === CHUNK - 1) yield (0.5 * i) / pieces.length;
    shade(piece, mesh, look, projection, lights);
  }
  const chains: Chain[] = [];
  const joints = new Joints(pieces);
  yield* asPhase(joints.join(), 0.5, 0.6);
  const walks = yield* asPhase(joints.walks(), 0.6, 0.7);
  let drawn = 0;
  for (const { steps, isClosed } of walks) {
    const drawing = new OutlineDrawing(mesh, look, projection, pen);
    for (const { piece, isReversed } of steps) {
      if (++drawn % CHUNK === 0) yield 0.7 + (0.3 * drawn) / pieces.length;
      const { start, end } = pieces[piece];
      drawing.add(pieces[piece], isReversed ? end : start, isReversed ? start : end);
    }
    chains.push(drawing.finish(isClosed));
  }
  return chains;
}

function shade(
  { start, end, contour }: OutlinePiece,
  { toWorld, normalToWorld }: OutlineMesh,
  { shadeWeights, lostEdges }: OutlineLook,
  { eye, backwards, isOrthographic }: Projection,
  lights: Illumination,
): void {
  const middle = transformed(toWorld, ...combined(0.5, start.position, 0.5, end.position));
  const light = meanLightAt(middle, lights.lamps, lights.around.skies);
  const sight = isOrthographic ? backwards : normalize(combined(1, eye, -1, middle));
  for (const side of [start, end]) {
    const normal = normalize(normalToWorld.map((row) => dot(row, side.normal)) as unknown as Vec3);
    const [weight, left] = shadeWeight(normal, contour, { light: normalize(light), sight, shadeWeights, lostEdges });
    side.weight *= weight;
    side.innerWeight *= weight;
    side.left = left;
  }
}

interface Step {
  piece: number;
  isReversed: boolean;
}

/** Connections between pieces. An end has the index of its piece times two, plus one for the second end. */
class Joints {
  private readonly ends = new Map<string, number[]>();

  constructor(private readonly pieces: readonly OutlinePiece[]) {}

  /** Finds the ends of pieces at each place. Yields its progress. */
  *join(): Generator<number, void, void> {
    const { pieces } = this;
    for (const [i, { start, end }] of pieces.entries()) {
      if (i % CHUNK === CHUNK - 1) yield i / pieces.length;
      for (const [k, { key }] of [start, end].entries()) {
        const list = this.ends.get(key);
        if (list) list.push(2 * i + k);
        else this.ends.set(key, [2 * i + k]);
      }
    }
  }

  /** The pieces in order along each outline. Yields its progress. */
  *walks(): Generator<number, { steps: Step[]; isClosed: boolean }[], void> {
    const { pieces } = this;
    let looked = 0;
    const used = new Uint8Array(pieces.length);
    const walks: { steps: Step[]; isClosed: boolean }[] = [];
    for (let first = 0; first < pieces.length; first++) {
      if (used[first]) continue;
      // From the first end as far as possible, then back.
      let end = 2 * first;
      for (let i = 0; i < pieces.length; i++) {
        if (++looked % CHUNK === 0) yield first / pieces.length;
        const next = this.partner(end);
        if (next < 0 || next >> 1 === first) break;
        end = next ^ 1;
      }
      const begin = end;
      const steps: Step[] = [];
      let next = end;
      while (next >= 0 && !used[next >> 1]) {
        if (++looked % CHUNK === 0) yield first / pieces.length;
        used[next >> 1] = 1;
        steps.push({ piece: next >> 1, isReversed: (next & 1) === 1 });
        next = this.partner(next ^ 1);
      }
      walks.push({ steps, isClosed: next === begin && steps.length > 2 });
    }
    return walks;
  }

  private endOf(code: number): PieceEnd {
    const { start, end } = this.pieces[code >> 1];
    return code & 1 ? end : start;
  }

  /** The end of another piece that continues an end; −1 where three meet, at sharp corners and where creases meet contours. */
  private partner(code: number): number {
    const list = this.ends.get(this.endOf(code).key)!;
    if (list.length !== 2 || list[0] >> 1 === list[1] >> 1) return -1;
    const other = list[0] === code ? list[1] : list[0];
    // A line that overshoots a corner ends there.
    if (this.endOf(code).overshoot > 0 || this.endOf(other).overshoot > 0) return -1;
    const [a, b] = [this.pieces[code >> 1], this.pieces[other >> 1]];
    if (isCrease(a) !== isCrease(b)) return -1;
    if (a.isSmooth || b.isSmooth) return other;
    return -dot(this.outwards(code), this.outwards(other)) < Math.cos(SHARPEST) ? -1 : other;
  }

  private outwards(code: number): Vec3 {
    const here = this.endOf(code).position;
    const there = this.endOf(code ^ 1).position;
    return normalize(combined(1, here, -1, there));
  }
}

const isCrease = ({ isSmooth, contour }: OutlinePiece): boolean => !isSmooth && contour === 0;

/** Draws the pieces of one outline into a chain. */
class OutlineDrawing {
  private readonly builder = new ChainBuilder();
  private readonly points: OutlinePoint[] = [];
  private last: { piece: OutlinePiece; from: PieceEnd; to: PieceEnd } | undefined;

  constructor(
    private readonly mesh: OutlineMesh,
    private readonly look: OutlineLook,
    private readonly projection: Projection,
    private readonly pen: number,
  ) {}

  add(piece: OutlinePiece, from: PieceEnd, to: PieceEnd): void {
    if (this.builder.count > 0) this.join(piece, from);
    else {
      this.runOn(piece, from, to);
      this.push(piece, from);
    }
    const pixels = this.pixelsBetween(from, to);
    const parts = Math.min(Math.max(1, Math.ceil(pixels / LONGEST_PIECE)), 4096);
    for (let i = 1; i < parts; i++) this.push(piece, endAt(from, to, i / parts));
    this.push(piece, to);
    this.last = { piece, from, to };
  }

  finish(isClosed: boolean): Chain {
    const { points, mesh, look, last } = this;
    if (last) this.runOn(last.piece, last.to, last.from);
    const radius = mesh.radius * mesh.scale;
    return {
      ...this.builder.finish(isClosed),
      outline: { points, radius, width: look.width, isCutOut: look.isCutOut },
    };
  }

  private worldOf({ position }: PieceEnd): Vec3 {
    return transformed(this.mesh.toWorld, ...position);
  }

  private pixelOf(end: PieceEnd): readonly [number, number] {
    const view = this.projection.toView(this.worldOf(end));
    const [x, y] = this.projection.project(...view);
    if (this.look.wobble === 0) return [x, y];
    const anchor = combined(1 / this.mesh.radius, end.anchor, 0, end.anchor);
    const [right, up] = wobbleAt(anchor, this.look.wobble);
    return [x + right, y - up];
  }

  private pixelsBetween(from: PieceEnd, to: PieceEnd): number {
    const [a, b] = [this.pixelOf(from), this.pixelOf(to)];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  }

  /** Extends the outline straight beyond an end of a piece, by the end's overshoot. */
  private runOn(piece: OutlinePiece, end: PieceEnd, other: PieceEnd): void {
    const pixels = this.pixelsBetween(end, other);
    if (end.overshoot === 0 || pixels === 0) return;
    const [near, far] = [end, other].map((one) => this.projection.depthOf(...this.worldOf(one)));
    const share = -end.overshoot / pixels;
    // The extension would lie behind the eye.
    if (!this.projection.isOrthographic && far + share * (near - far) < 0.5 * far) return;
    const place = endAt(end, other, this.projection.shareInSpace(share, near, far));
    this.push(piece, { ...end, position: place.position });
  }

  /** Half the width before paper, and before a surface. @param spacing the distance of the lines there, object units */
  private halvesAt({ weight, innerWeight }: PieceEnd, world: Vec3, spacing: number): readonly [number, number] {
    const { width, fading } = this.look;
    const pixel = this.projection.unitsPerPixel(this.projection.depthOf(...world));
    const most = crowdedHalf((spacing * this.mesh.scale) / pixel, width, this.pen);
    const factor = fading === null ? 1 : outlineFadingAt(fading, fadedPlace(world, this.projection));
    const halfOf = (one: number): number => factor * Math.min(0.5 * width * one, most);
    return [halfOf(weight), halfOf(innerWeight)];
  }

  private push({ isSmooth, extent, ownCover, isValley, contour, spacing }: OutlinePiece, end: PieceEnd): void {
    const { near } = this.projection.camera;
    const world = this.worldOf(end);
    const [half, inner] = this.halvesAt(end, world, spacing);
    // Points before the near plane cannot be projected.
    const isBehind = this.projection.depthOf(...world) >= near;
    const screen = isBehind ? this.pixelOf(end) : [0, 0];
    this.builder.push(screen, world, half, isBehind ? Math.max(half, inner) : -1, -1);
    const { scale } = this.mesh;
    this.points.push({
      ...{ isSmooth, bend: end.bend, extent: extent * scale, ownCover: ownCover * scale, isValley },
      ...{ innerHalf: inner, accent: this.look.accents * contour, contour, left: end.left },
    });
  }

  /** Continues over another piece from the last point, which gets the mean width and the lift of both. */
  private join({ isSmooth, extent, contour, spacing }: OutlinePiece, end: PieceEnd): void {
    const [half, inner] = this.halvesAt(end, this.worldOf(end), spacing);
    this.builder.share(half, Math.max(half, inner), -1);
    const before = this.points.pop()!;
    this.points.push({
      ...before,
      isSmooth: isSmooth || before.isSmooth,
      bend: Math.min(before.bend, end.bend),
      extent: Math.max(before.extent, extent * this.mesh.scale),
      innerHalf: 0.5 * (before.innerHalf + inner),
      accent: 0.5 * (before.accent + this.look.accents * contour),
      contour: 0.5 * (before.contour + contour),
      left: 0.5 * (before.left + end.left),
    });
  }
}

/** An end interpolated between two. */
function endAt(a: PieceEnd, b: PieceEnd, share: number): PieceEnd {
  const rest = 1 - share;
  return {
    ...a,
    position: combined(rest, a.position, share, b.position),
    anchor: combined(rest, a.anchor, share, b.anchor),
    normal: combined(rest, a.normal, share, b.normal),
    bend: rest * a.bend + share * b.bend,
    weight: rest * a.weight + share * b.weight,
    innerWeight: rest * a.innerWeight + share * b.innerWeight,
    left: rest * a.left + share * b.left,
  };
}
