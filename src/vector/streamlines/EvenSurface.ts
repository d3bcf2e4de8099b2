import { type Vec3, vectorAt } from '../../look/vectors.js';
import type { Bvh } from '../Bvh.js';
import type { DrawnScene, EngravedSurface } from '../DrawnScene.js';
import { Engraver } from '../Engraver.js';
import { STRIDE, type SurfacePlace } from '../LineSurface.js';
import type { Projection } from '../Projection.js';
import { PlaceReader } from '../paint/PlaceReader.js';
import type { Translucency } from '../paint/Translucency.js';
import { ToneReader, type Tones } from '../ToneReader.js';
import { hasLay, type LayName } from './layTones.js';

/** A scene as a camera sees it. */
export interface SeenScene {
  scene: DrawnScene;
  projection: Projection;
  bvh: Bvh;
  translucency: Translucency;
}

/** A surface whose lines are placed on the sheet. */
export class EvenSurface {
  private readonly places: PlaceReader;
  private readonly toneReader: ToneReader;
  /** The first where all lights arrive, and the others in the shadows that turn lines. */
  private readonly engravers: Engraver[];
  private readonly numbers = new Float64Array(STRIDE);
  /** The triangle of the surface for each of the scene, from its first one on. */
  private readonly localOf: Int32Array;

  private readonly scene: DrawnScene;
  private readonly projection: Projection;
  private readonly translucency: Translucency;

  /** @param facing per triangle of the scene 1 if its front is visible, −1 if its back is */
  constructor(
    readonly drawn: EngravedSurface,
    { scene, bvh, projection, translucency }: SeenScene,
    facing: Int8Array,
  ) {
    this.scene = scene;
    this.projection = projection;
    this.translucency = translucency;
    const { surface, look, paint, turned } = drawn;
    const { parents } = surface;
    this.localOf = new Int32Array(parents.length > 0 ? parents[parents.length - 1] - parents[0] + 1 : 0);
    for (const [local, triangle] of parents.entries()) this.localOf[triangle - parents[0]] = local;
    const sides = Int8Array.from(surface.parents, (triangle) => facing[triangle]);
    this.places = new PlaceReader(surface, paint, sides, projection);
    this.toneReader = new ToneReader(look, scene.illumination, bvh, projection);
    this.engravers = [drawn, ...turned].map(
      ({ engraved, field }) => new Engraver(engraved, field, surface.viewToField, projection),
    );
  }

  /** Whether a triangle of the scene is one of the surface. */
  owns(triangle: number): boolean {
    const { parents } = this.drawn.surface;
    return parents[this.localOf[triangle - parents[0]]] === triangle;
  }

  /** The place that is seen at a position on the picture, pixels. triangle: of the scene. */
  placeAt(x: number, y: number, triangle: number): SurfacePlace {
    const { surface } = this.drawn;
    const local = this.localOf[triangle - surface.parents[0]];
    const weights = this.weightsAt(x, y, triangle);
    const { vertices, triangles } = surface;
    this.numbers.fill(0);
    for (let k = 0; k < 3; k++) {
      const o = STRIDE * triangles[3 * local + k];
      for (let n = 0; n < STRIDE; n++) this.numbers[n] += weights[k] * vertices[o + n];
    }
    return this.places.read(this.numbers, local);
  }

  /** The weights of the corners of a triangle where the ray through a pixel meets it (Möller and Trumbore, 1997). */
  private weightsAt(px: number, py: number, triangle: number): Vec3 {
    const { corners } = this.scene;
    const { origin: o, direction: d } = this.projection.rayThrough(px, py);
    const [a, b, c] = [0, 3, 6].map((k) => vectorAt(corners, 9 * triangle + k));
    const [e1x, e1y, e1z] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    const [e2x, e2y, e2z] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    const [hx, hy, hz] = [d[1] * e2z - d[2] * e2y, d[2] * e2x - d[0] * e2z, d[0] * e2y - d[1] * e2x];
    const scale = 1 / (e1x * hx + e1y * hy + e1z * hz);
    const [sx, sy, sz] = [o[0] - a[0], o[1] - a[1], o[2] - a[2]];
    const u = scale * (sx * hx + sy * hy + sz * hz);
    const [qx, qy, qz] = [sy * e1z - sz * e1y, sz * e1x - sx * e1z, sx * e1y - sy * e1x];
    const v = scale * (d[0] * qx + d[1] * qy + d[2] * qz);
    return [1 - u - v, u, v];
  }

  /** The tones at a place, lighter behind see-through surfaces. triangle: of the scene. */
  tonesAt(place: SurfacePlace, triangle: number): Tones {
    const tones = this.toneReader.read(place, this.toneReader.hasShadows ? 'traced' : 'none');
    const left = this.translucency.transmittance(place.world, triangle);
    return left === 1 ? tones : { ...tones, tone: left * tones.tone, unshadowed: left * tones.unshadowed };
  }

  /** The number of the engraver of the lines where some lights do not arrive. turned: those lights, as bits. */
  engraverIn(turned: number): number {
    return this.drawn.turned.findIndex(({ shadows }) => shadows === turned) + 1;
  }

  hasLay(name: LayName): boolean {
    return this.engravers.some((engraver) => hasLay(engraver, name));
  }

  engraver(number: number): Engraver {
    return this.engravers[number];
  }
}
