import { combined, cross, dot, type Vec3, vectorAt } from '../../look/vectors.js';
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
    const [a, b, c] = this.weightsAt(x, y, triangle);
    const { vertices, triangles } = surface;
    const first = STRIDE * triangles[3 * local];
    const second = STRIDE * triangles[3 * local + 1];
    const third = STRIDE * triangles[3 * local + 2];
    for (let n = 0; n < STRIDE; n++)
      this.numbers[n] = a * vertices[first + n] + b * vertices[second + n] + c * vertices[third + n];
    return this.places.read(this.numbers, local);
  }

  /** The weights of the corners of a triangle where the ray through a pixel meets it (Möller and Trumbore, 1997). */
  weightsAt(px: number, py: number, triangle: number): Vec3 {
    const { corners } = this.scene;
    const { origin, direction } = this.projection.rayThrough(px, py);
    const a = vectorAt(corners, 9 * triangle);
    const toB = combined(1, vectorAt(corners, 9 * triangle + 3), -1, a);
    const toC = combined(1, vectorAt(corners, 9 * triangle + 6), -1, a);
    const across = cross(direction, toC);
    const scale = 1 / dot(toB, across);
    const from = combined(1, origin, -1, a);
    const u = scale * dot(from, across);
    const v = scale * dot(direction, cross(from, toB));
    return [1 - u - v, u, v];
  }

  /** The tones at a place, lighter behind see-through surfaces. triangle: of the scene. */
  tonesAt(place: SurfacePlace, triangle: number, shadowing: 'traced' | 'hard'): Tones {
    const tones = this.toneReader.read(place, this.toneReader.hasShadows ? shadowing : 'none');
    const left = this.translucency.transmittance(place.world, triangle);
    return left === 1 ? tones : { ...tones, tone: left * tones.tone, unshadowed: left * tones.unshadowed };
  }

  /** Whether tones depend on the light, the normal and the occlusion alone. */
  get isPlain(): boolean {
    return this.drawn.paint === null && this.scene.translucent.length === 0;
  }

  /** The lamps that do not arrive at a place, as bits, by one ray to each. */
  darkAt(place: SurfacePlace): number {
    return this.toneReader.darkAt(place);
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
