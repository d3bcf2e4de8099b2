import {
  BackSide,
  type Camera,
  DoubleSide,
  type InstancedMesh,
  type Material,
  type Mesh,
  type Object3D,
  type PerspectiveCamera,
  type Plane,
} from 'three';
import { mix } from '../../look/vectors.js';
import { ExposureFit } from '../../material/exposure/ExposureFit.js';
import { planScene } from '../../material/exposure/planScene.js';
import type { ToneFit } from '../../material/exposure/ToneFit.js';
import { isFormed } from '../../material/geometry/formGeometry.js';
import { outlineDataOf } from '../../material/geometry/OutlineData.js';
import type { HatchingBackground } from '../../material/HatchingBackground.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import type { HatchingOutlineMaterial } from '../../material/outlines/HatchingOutlineMaterial.js';
import type { HatchingOutlines } from '../../material/outlines/HatchingOutlines.js';
import { OutlineParts } from '../../material/outlines/OutlineParts.js';
import { isClipped, type SurfacePart, surfaceParts } from '../../material/outlines/surfaceRules.js';
import { asPhase } from '../../mesh/phases.js';
import { CASTS_BACK, CASTS_FRONT, FADES_FRONT, MAY_HAVE_HOLES, SEEN_BACK, SEEN_FRONT } from '../Bvh.js';
import type { DrawnBackground, DrawnScene, EngravedSurface, OutlinedMesh, StippledSurface } from '../DrawnScene.js';
import { GrowingArray } from '../GrowingArray.js';
import { moveToOrigin } from '../moveToOrigin.js';
import { transformed } from '../Projection.js';
import type { Cutout } from '../paint/PaintLook.js';
import type { TranslucentRange } from '../paint/Translucency.js';
import type { PenPlan } from '../plot/pens.js';
import { drawnWithout, faultOf, isStippled, type LeftOut, sentence, untestedBy, whyNoLines } from './leftOut.js';
import { PenMatcher } from './matchPens.js';
import { type MeshCopy, meshCopies } from './meshCopies.js';
import { alphaTestOf, type Painted, PaintReader } from './PaintReader.js';
import { type PosedVertices, posedVertices } from './posedVertices.js';
import { fieldOf, hasTooManyTurns, turnedLinesOf } from './readField.js';
import { readLights, type SceneLights } from './readLights.js';
import { engravedLookOf, readBackground, readFading, readOutlineFading, surfaceLookOf } from './readLook.js';
import { outlineLookOf, readOutlines } from './readOutlines.js';
import {
  type DetailSource,
  firstCoordinate,
  flattened,
  readDetails,
  readStippled,
  readSurface,
  type TriangleRange,
} from './readSurface.js';
import { clipOf, leftBehind, shadowClipOf, variesInOpacity } from './seenThrough.js';
import { objectFrame, surfaceFrame } from './surfaceFrame.js';

/** Height at which shadow rays start, as a share of the size of the largest mesh that casts shadows. */
const SHADOW_BIAS = 0.01;

/**
 * Reads a scene as plain data, and lists what is not in it. Updates the world matrices of scene and camera. Yields its progress.
 *
 * @param shadows as in `DrawSVGOptions`
 * @param clippingPlanes planes that clip everything
 * @param pens of a plotter; null for a print
 */
export function* readScene(
  scene: Object3D,
  camera: Camera,
  shadows: boolean | 'hard' | 'soft',
  clippingPlanes: readonly Plane[] = [],
  pens: PenPlan | null = null,
): Generator<number, { drawn: DrawnScene; leftOut: LeftOut[] }, void> {
  scene.updateMatrixWorld();
  camera.updateMatrixWorld();
  const lights = readLights(scene, camera, shadows !== false);
  const reader = new SceneReader(scene, camera, lights, shadows !== 'hard', clippingPlanes, pens);
  const objects: Object3D[] = [];
  scene.traverseVisible((object) => {
    if (object.layers.test(camera.layers)) objects.push(object);
  });
  for (const [i, object] of objects.entries())
    yield* asPhase(reader.readMesh(object), (0.8 * i) / objects.length, (0.8 * (i + 1)) / objects.length);
  for (const [i, object] of objects.entries())
    yield* asPhase(
      reader.readOutlinesOf(object),
      0.8 + (0.2 * i) / objects.length,
      0.8 + (0.2 * (i + 1)) / objects.length,
    );
  return { drawn: moveToOrigin(reader.drawn()), leftOut: reader.leftOut };
}

/** Factor from the bit of a visible side to that of a side that fades what is behind it. */
const FADING = FADES_FRONT / SEEN_FRONT;

/** Triangles per step. */
const CHUNK = 4096;
/** The share of deforming vertices in the time for reading a mesh. */
const POSING = 0.1;

class SceneReader {
  readonly leftOut: LeftOut[] = [];
  private readonly corners = new GrowingArray(new Float64Array(0));
  private readonly sides = new GrowingArray(new Uint8Array(0));
  private readonly surfaces: EngravedSurface[] = [];
  private readonly stippled: StippledSurface[] = [];
  private readonly outlines: OutlinedMesh[] = [];
  private readonly backgrounds: DrawnBackground[] = [];
  private readonly cutouts: Cutout[] = [];
  private readonly translucent: TranslucentRange[] = [];
  private readonly paints: PaintReader;
  /** The placements of each visible mesh. */
  private readonly copies = new Map<Object3D, { copy: MeshCopy; posed: PosedVertices }[]>();
  private readonly fit: ToneFit;
  private readonly matcher: PenMatcher;
  private casterSize = 0;

  constructor(
    scene: Object3D,
    private readonly camera: Camera,
    private readonly lights: SceneLights,
    private readonly hasSoftShadows: boolean,
    private readonly clippingPlanes: readonly Plane[],
    private readonly pens: PenPlan | null,
  ) {
    this.matcher = new PenMatcher(pens?.pens ?? []);
    this.fit = new ExposureFit((use) => use(planScene)).update(scene, camera.layers.mask);
    this.paints = new PaintReader(this.fit);
  }

  drawn(): DrawnScene {
    const { corners, sides, surfaces, stippled, outlines, backgrounds, camera, lights, casterSize } = this;
    const { lamps, shadows, around } = lights;
    return {
      camera: {
        view: [...camera.matrixWorldInverse.elements],
        world: [...camera.matrixWorld.elements],
        projection: [...camera.projectionMatrix.elements],
        near: (camera as PerspectiveCamera).near ?? 0,
      },
      corners: corners.taken(),
      sides: sides.taken(),
      cutouts: this.cutouts,
      translucent: this.translucent,
      ...{ surfaces, stippled, outlines, backgrounds },
      illumination: { lamps, shadows, isSoft: this.hasSoftShadows, around, bias: SHADOW_BIAS * casterSize },
    };
  }

  *readMesh(object: Object3D): Generator<number, void, void> {
    if ('isHatchingBackground' in object) this.readBackground(object as unknown as HatchingBackground);
    else if ('isLine' in object || 'isPoints' in object || ('isSprite' in object && !isOutlines(object)))
      this.note(object, 'is left out: it is no mesh');
    else if ('isMesh' in object) yield* this.readSurfaces(object as Mesh);
  }

  private readBackground(object: HatchingBackground): void {
    const background = readBackground(object, this.camera, this.lights);
    if (background) this.backgrounds.push({ ...background, ink: this.matcher.inkFor(background.ink) });
  }

  private note(object: Object3D, what: string): void {
    this.leftOut.push(sentence(object, what));
  }

  private *readSurfaces(mesh: Mesh): Generator<number, void, void> {
    const fault = faultOf(mesh);
    if (fault) {
      this.note(mesh, fault);
      return;
    }
    const parts = surfaceParts(mesh);
    if (parts.length === 0) return;
    if (!mesh.geometry.attributes.position) {
      this.note(mesh, 'is left out: its geometry has no positions');
      return;
    }
    const copies = meshCopies(mesh);
    const hasOwnPoses = (mesh as InstancedMesh).morphTexture != null;
    let posed: PosedVertices | undefined;
    for (const [i, copy] of copies.entries()) {
      const [from, to] = [i / copies.length, (i + 1) / copies.length];
      const middle = from + POSING * (to - from);
      if (!posed || hasOwnPoses)
        posed = yield* asPhase(posedVertices(mesh, hasOwnPoses ? copy.instance : -1), from, middle);
      yield* asPhase(this.readCopy(mesh, copy, posed, parts), middle, to);
    }
    for (const { material } of parts) {
      const unread = this.paints.unreadable(material as Painted);
      if (unread.length > 0) this.note(mesh, `is drawn without ${unread.join(', ')}: pixels that cannot be read here`);
      const untested = untestedBy(material);
      if (untested) this.note(mesh, untested);
      if (variesInOpacity(mesh.geometry, material))
        this.note(mesh, 'is drawn with one opacity, the mean of those of its vertices');
      const noLines = whyNoLines(mesh, material);
      if (noLines) this.note(mesh, noLines);
      else
        for (const what of drawnWithout(material as HatchingMaterial, this.lights.lamps.length)) this.note(mesh, what);
    }
  }

  private *readCopy(
    mesh: Mesh,
    copy: MeshCopy,
    posed: PosedVertices,
    parts: readonly SurfacePart[],
  ): Generator<number, void, void> {
    const known = this.copies.get(mesh) ?? [];
    this.copies.set(mesh, [...known, { copy, posed }]);
    if (mesh.castShadow) this.noteCaster(mesh, copy);
    for (const [i, part] of parts.entries()) {
      const [from, to] = [i / parts.length, (i + 1) / parts.length];
      const [read, divided, added] = [0.1, 0.15, 0.4].map((share) => mix(from, to, share));
      const corners = yield* asPhase(cornersOf(mesh, part, copy), from, read);
      const paint = this.paints.needs(mesh, part.material, copy);
      const source = { mesh, copy, posed, material: part.material as Painted, paint };
      const isDrawn = whyNoLines(mesh, part.material) === undefined && part.material.colorWrite;
      const ofPens = isDrawn
        ? yield* asPhase(this.matcher.divide(source, corners), read, divided)
        : [{ ink: null, corners }];
      const sorted = ofPens.length === 1 ? corners : joined(ofPens.map((one) => one.corners));
      let firstTriangle = yield* asPhase(this.addTriangles(source, sorted), divided, added);
      if (!isDrawn) continue;
      for (const [k, { ink, corners }] of ofPens.entries()) {
        const adding = this.addSurface(source, part.material as HatchingMaterial, { corners, firstTriangle }, ink);
        yield* asPhase(adding, mix(added, to, k / ofPens.length), mix(added, to, (k + 1) / ofPens.length));
        firstTriangle += corners.length / 3;
      }
    }
  }

  private noteCaster({ geometry }: Mesh, { toWorld }: MeshCopy): void {
    if (!geometry.boundingSphere) geometry.computeBoundingSphere();
    const size = geometry.boundingSphere!.radius * toWorld.getMaxScaleOnAxis();
    if (size > this.casterSize) this.casterSize = size;
  }

  /** Adds triangles that hide and cast shadows. Returns the index of the first. */
  private *addTriangles(source: DetailSource, corners: Uint32Array): Generator<number, number, void> {
    const { mesh, copy, posed, material } = source;
    const { positions } = posed;
    const first = this.sides.length;
    const left = leftBehind(material, mesh.geometry);
    const seen = left > 0 ? FADING * sidesOf(material) : material.depthWrite ? sidesOf(material) : 0;
    if (left > 0 && left < 1) this.translucent.push({ first, end: first + corners.length / 3, left });
    let bits = seen | (mesh.castShadow ? castingOf(material) : 0);
    const cutout = this.cutoutOf(source, { corners, firstTriangle: first });
    if (cutout) {
      this.cutouts.push(cutout);
      bits |= MAY_HAVE_HOLES;
    }
    this.corners.reserve(this.corners.length + 3 * corners.length);
    this.sides.reserve(first + corners.length / 3);
    for (let c = 0; c < corners.length; c++) {
      if (c % (3 * CHUNK) === 0) yield c / corners.length;
      const o = 3 * corners[c];
      const place = transformed(copy.toWorld.elements, positions[o], positions[o + 1], positions[o + 2]);
      for (const coordinate of place) this.corners.push(coordinate);
      if (c % 3 === 0) this.sides.push(bits);
    }
    return first;
  }

  /** The holes of triangles; null for none. */
  private cutoutOf(source: DetailSource, range: TriangleRange): Cutout | null {
    const { material, paint } = source;
    const details = paint && alphaTestOf(material) > 0 ? readDetails(source, range, null) : null;
    const painted = details && paint && { details, paint: this.paints.paint(source, paint, 0) };
    const clip = clipOf(material, this.clippingPlanes);
    if (!painted && !clip) return null;
    const first = range.firstTriangle;
    return { first, end: first + range.corners.length / 3, painted, clip, shadowClip: shadowClipOf(material) };
  }

  private *addSurface(
    source: DetailSource,
    material: HatchingMaterial,
    range: TriangleRange,
    penInk: string | null,
  ): Generator<number, void, void> {
    const { camera, lights, fit, paints } = this;
    const { mesh, copy, paint } = source;
    const group = this.groupOf(mesh, material);
    const look = surfaceLookOf(material, mesh, fit, readFading(mesh, material, camera));
    const clip = clipOf(material, this.clippingPlanes);
    const ink = penInk ?? colorOf(material);
    if (isStippled(material)) {
      const reading = readStippled(source, material, range, camera.matrixWorldInverse, sidesOf(material));
      const { surface: smooth, ...dots } = yield* reading;
      const surface = isFlat(material) ? yield* flattened(smooth) : smooth;
      const first = firstCoordinate(source, objectFrame(mesh, copy.toWorld, camera.matrixWorldInverse));
      const painted = paint && paints.paint(source, paint, first);
      this.stippled.push({ ...dots, surface, look, paint: painted, clip, ink, group });
      return;
    }
    const engraved = engravedLookOf(material, isFormed(mesh.geometry));
    const frame = surfaceFrame(mesh, copy.toWorld, material, engraved, camera.matrixWorldInverse);
    const smooth = yield* readSurface(source, range, frame, sidesOf(material));
    const laid = { engraved, material, frame, surface: smooth };
    if (mesh.receiveShadow && hasTooManyTurns(laid, lights.lamps))
      this.note(mesh, 'is drawn with lines that do not turn in shadows: too many lights cast them');
    this.surfaces.push({
      surface: isFlat(material) ? yield* flattened(smooth) : smooth,
      engraved,
      field: fieldOf(laid, lights.lamps),
      turned: mesh.receiveShadow ? turnedLinesOf(laid, lights.lamps) : [],
      look,
      hides: material.depthWrite && leftBehind(material, mesh.geometry) === 0,
      paint: paint && paints.paint(source, paint, firstCoordinate(source, frame)),
      ...{ clip, ink, group },
    });
  }

  /** The name of the material or part that a surface belongs to, if these have layers of their own. */
  private groupOf(mesh: Mesh, material: Material | undefined): string {
    if (this.pens?.layers === 'part') return mesh.name;
    return this.pens?.layers === 'material' ? (material?.name ?? '') : '';
  }

  *readOutlinesOf(object: Object3D): Generator<number, void, void> {
    if (!isOutlines(object)) return;
    const { mesh, material } = object;
    const outlineParts = new OutlineParts();
    const copies = mesh && this.copies.get(mesh);
    if (!mesh || !copies) return;
    const data = outlineDataOf(mesh.geometry);
    if (!data) {
      this.note(mesh, 'has no outlines: its geometry was prepared without them');
      return;
    }
    const parts = outlineParts.of(mesh, data);
    if (parts.length === 0) return;
    if (material.paperGrain > 0) this.note(mesh, 'has outlines of ink: the tooth of the paper cannot leave as lines');
    for (const { copy, posed } of copies)
      for (const { data: ofPart, surface } of parts)
        this.outlines.push({
          mesh: yield* readOutlines(mesh, ofPart, { toWorld: copy.toWorld, posed }, this.camera),
          look: outlineLookOf(
            material,
            surface,
            mesh.geometry,
            Array.isArray(mesh.material),
            readOutlineFading(mesh, this.camera),
          ),
          clip: clipOf(isClipped(material) ? material : surface, this.clippingPlanes),
          ink: this.matcher.inkFor(colorOf(material)),
          group: this.groupOf(mesh, surface),
        });
    outlineParts.dispose();
  }
}

function joined(parts: readonly Uint32Array[]): Uint32Array {
  const all = new Uint32Array(parts.reduce((sum, { length }) => sum + length, 0));
  let length = 0;
  for (const part of parts) {
    all.set(part, length);
    length += part.length;
  }
  return all;
}

const isOutlines = (object: Object3D): object is HatchingOutlines => 'isHatchingOutlines' in object;

/** Whether tone is computed from face normals. */
const isFlat = ({ toneNormal, flatShading }: HatchingMaterial): boolean => toneNormal === 'face' || flatShading;

const colorOf = ({ ink }: HatchingMaterial | HatchingOutlineMaterial): string => `#${ink.getHexString()}`;

/** The sides that a material draws. */
function sidesOf({ side }: Material): number {
  if (side === DoubleSide) return SEEN_FRONT | SEEN_BACK;
  return side === BackSide ? SEEN_BACK : SEEN_FRONT;
}

/** The sides that cast shadows, by three.js' rule: for one-sided surfaces the side that is not drawn. */
function castingOf({ side, shadowSide }: Material): number {
  const casts = shadowSide ?? (side === DoubleSide ? DoubleSide : side === BackSide ? 0 : BackSide);
  if (casts === DoubleSide) return CASTS_FRONT | CASTS_BACK;
  return casts === BackSide ? CASTS_BACK : CASTS_FRONT;
}

/** The vertices of the corners of a part, with reversed winding if the mesh is mirrored. Yields its progress. */
function* cornersOf(
  { geometry: { index }, matrixWorld }: Mesh,
  part: SurfacePart,
  { range }: MeshCopy,
): Generator<number, Uint32Array, void> {
  const start = Math.max(part.start, range?.start ?? 0);
  const end = Math.min(part.end, range ? range.start + range.count : Infinity);
  const count = 3 * Math.floor(Math.max(end - start, 0) / 3);
  const corners = new Uint32Array(count);
  // three.js determines the front side by the mesh alone, not by its instances.
  const isMirrored = matrixWorld.determinant() < 0;
  for (let c = 0; c < count; c++) {
    if (c % (3 * CHUNK) === 3 * CHUNK - 1) yield c / count;
    // The first two corners of each triangle are exchanged.
    const turned = isMirrored && c % 3 < 2 ? c + 1 - 2 * (c % 3) : c;
    corners[c] = index ? index.getX(start + turned) : start + turned;
  }
  return corners;
}
