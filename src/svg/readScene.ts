import {
  BackSide,
  type Camera,
  DoubleSide,
  type Material,
  type Matrix4,
  type Mesh,
  type Object3D,
  type PerspectiveCamera,
} from 'three';
import type { HatchingBackground } from '../background/HatchingBackground.js';
import type { Vec3 } from '../engraving/vectors.js';
import { isFormed } from '../geometry/formGeometry.js';
import { outlineDataOf } from '../geometry/OutlineData.js';
import { ExposureFit } from '../material/exposure/ExposureFit.js';
import type { ToneFit } from '../material/exposure/ToneFit.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import type { HatchingOutlineMaterial } from '../outlines/HatchingOutlineMaterial.js';
import type { HatchingOutlines } from '../outlines/HatchingOutlines.js';
import { asPhase } from '../slices/asPhase.js';
import { CASTS_BACK, CASTS_FRONT, SEEN_BACK, SEEN_FRONT } from '../vector/Bvh.js';
import type {
  DrawnBackground,
  DrawnScene,
  EngravedSurface,
  OutlinedMesh,
  StippledSurface,
} from '../vector/DrawnScene.js';
import { GrowingArray } from '../vector/GrowingArray.js';
import { drawnWithout, faultOf, isStippled, type LeftOut, sentence, whyNoLines, whyNothing } from './leftOut.js';
import { readBackground } from './readBackground.js';
import { readEmphasis, readOutlineEmphasis } from './readEmphasis.js';
import { fieldOf, hasTooManyTurns, turnedLinesOf } from './readField.js';
import { readLights, type SceneLights } from './readLights.js';
import { engravedLookOf, surfaceLookOf } from './readLook.js';
import { outlineLookOf, readOutlines } from './readOutlines.js';
import { readStippled } from './readStippled.js';
import { readSurface, surfaceFrame } from './readSurface.js';

/** How far rays of shadows begin above what they are cast on, as a share of the size of the largest mesh that casts them. */
const SHADOW_BIAS = 0.01;

/**
 * Reads a scene as plain data, and names what is not in it. Brings the world matrices of scene and camera up to date. Yields its progress.
 *
 * @param shadows as of `DrawSVGOptions`
 */
export function* readScene(
  scene: Object3D,
  camera: Camera,
  shadows: boolean | 'hard' | 'soft',
): Generator<number, { drawn: DrawnScene; leftOut: LeftOut[] }, void> {
  scene.updateMatrixWorld();
  camera.updateMatrixWorld();
  const reader = new SceneReader(scene, camera, readLights(scene, camera, shadows !== false), shadows !== 'hard');
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
  return { drawn: reader.drawn(), leftOut: reader.leftOut };
}

/** Triangles are read so many at a time. */
const CHUNK = 4096;

class SceneReader {
  readonly leftOut: LeftOut[] = [];
  private readonly corners = new GrowingArray(new Float64Array(0));
  private readonly sides = new GrowingArray(new Uint8Array(0));
  private readonly surfaces: EngravedSurface[] = [];
  private readonly stippled: StippledSurface[] = [];
  private readonly outlines: OutlinedMesh[] = [];
  private readonly backgrounds: DrawnBackground[] = [];
  /** The first triangle of each mesh that is drawn. */
  private readonly firstTriangles = new Map<Object3D, number>();
  private readonly fit: ToneFit;
  private casterSize = 0;

  constructor(
    scene: Object3D,
    private readonly camera: Camera,
    private readonly lights: SceneLights,
    private readonly hasSoftShadows: boolean,
  ) {
    this.fit = new ExposureFit().update(scene, camera.layers.mask);
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
    if (background) this.backgrounds.push(background);
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
    const parts = partsOf(mesh);
    if (parts.length === 0) return;
    const nothing = whyNothing(mesh);
    if (nothing) {
      this.note(mesh, nothing);
      return;
    }
    this.firstTriangles.set(mesh, this.sides.length);
    if (mesh.castShadow) this.noteCaster(mesh);
    for (const [i, { material, start, end }] of parts.entries()) {
      const corners = cornersOf(mesh, start, end);
      const from = i / parts.length;
      const middle = (i + 0.4) / parts.length;
      const firstTriangle = yield* asPhase(this.addTriangles(mesh, material, corners), from, middle);
      const noLines = whyNoLines(mesh, material);
      if (noLines) this.note(mesh, noLines);
      else {
        const adding = this.addSurface(mesh, material as HatchingMaterial, corners, firstTriangle);
        yield* asPhase(adding, middle, (i + 1) / parts.length);
      }
    }
  }

  private noteCaster({ geometry, matrixWorld }: Mesh): void {
    if (!geometry.boundingSphere) geometry.computeBoundingSphere();
    const size = geometry.boundingSphere!.radius * matrixWorld.getMaxScaleOnAxis();
    if (size > this.casterSize) this.casterSize = size;
  }

  /** Adds triangles to what hides and casts shadows. Returns the number of the first. */
  private *addTriangles(mesh: Mesh, material: Material, corners: Uint32Array): Generator<number, number, void> {
    const first = this.sides.length;
    const { position } = mesh.geometry.attributes;
    const isMirrored = mesh.matrixWorld.determinant() < 0;
    const bits = (material.depthWrite ? sidesOf(material) : 0) | (mesh.castShadow ? castingOf(material) : 0);
    for (let c = 0; c < corners.length; c += 3) {
      if (c % (3 * CHUNK) === 0) yield c / corners.length;
      const [i, j, k] = corners.subarray(c, c + 3);
      for (const vertex of isMirrored ? [j, i, k] : [i, j, k])
        for (const number of placed(
          mesh.matrixWorld,
          position.getX(vertex),
          position.getY(vertex),
          position.getZ(vertex),
        ))
          this.corners.push(number);
      this.sides.push(bits);
    }
    return first;
  }

  private *addSurface(
    mesh: Mesh,
    material: HatchingMaterial,
    corners: Uint32Array,
    firstTriangle: number,
  ): Generator<number, void, void> {
    const { camera, lights, fit } = this;
    for (const what of drawnWithout(material)) this.note(mesh, what);
    const look = surfaceLookOf(material, mesh.receiveShadow, fit, readEmphasis(mesh, material, camera));
    const range = { corners, firstTriangle };
    if (isStippled(material)) {
      const reading = readStippled(mesh, material, range, camera.matrixWorldInverse, sidesOf(material));
      this.stippled.push({ ...(yield* reading), look, ink: colorOf(material) });
      return;
    }
    const frame = surfaceFrame(mesh, material, camera.matrixWorldInverse);
    const engraved = engravedLookOf(material, isFormed(mesh.geometry));
    const surface = yield* readSurface(mesh.geometry, range, frame, sidesOf(material));
    const laid = { engraved, material, frame, surface };
    if (mesh.receiveShadow && hasTooManyTurns(laid, lights.lamps))
      this.note(mesh, 'is drawn with lines that do not turn in shadows: too many lights cast them');
    this.surfaces.push({
      surface,
      engraved,
      field: fieldOf(laid, lights.lamps),
      turned: mesh.receiveShadow ? turnedLinesOf(laid, lights.lamps) : [],
      look,
      hides: material.depthWrite,
      ink: colorOf(material),
    });
  }

  *readOutlinesOf(object: Object3D): Generator<number, void, void> {
    if (!isOutlines(object)) return;
    const { mesh, material } = object;
    const firstTriangle = mesh ? this.firstTriangles.get(mesh) : undefined;
    if (!mesh || firstTriangle === undefined) return;
    const data = outlineDataOf(mesh.geometry);
    if (!data) {
      this.note(mesh, 'has no outlines: its geometry was prepared without them');
      return;
    }
    if (material.tooth > 0) this.note(mesh, 'has outlines of ink: the tooth of the paper cannot leave as lines');
    this.outlines.push({
      mesh: yield* readOutlines(mesh, data, this.camera, firstTriangle),
      look: outlineLookOf(material, Array.isArray(mesh.material), readOutlineEmphasis(mesh, this.camera)),
      ink: colorOf(material),
    });
  }
}

const isOutlines = (object: Object3D): object is HatchingOutlines => 'isHatchingOutlines' in object;

const colorOf = ({ ink }: HatchingMaterial | HatchingOutlineMaterial): string => `#${ink.getHexString()}`;

/** A point of an object in the world. */
function placed({ elements: e }: Matrix4, x: number, y: number, z: number): Vec3 {
  return [
    e[0] * x + e[4] * y + e[8] * z + e[12],
    e[1] * x + e[5] * y + e[9] * z + e[13],
    e[2] * x + e[6] * y + e[10] * z + e[14],
  ];
}

/** The sides of triangles that a material draws. */
function sidesOf({ side }: Material): number {
  if (side === DoubleSide) return SEEN_FRONT | SEEN_BACK;
  return side === BackSide ? SEEN_BACK : SEEN_FRONT;
}

/** The sides that cast shadows, by three's rule: of one-sided surfaces the side that is not drawn. */
function castingOf({ side, shadowSide }: Material): number {
  const casts = shadowSide ?? (side === DoubleSide ? DoubleSide : side === BackSide ? 0 : BackSide);
  if (casts === DoubleSide) return CASTS_FRONT | CASTS_BACK;
  return casts === BackSide ? CASTS_BACK : CASTS_FRONT;
}

/** A part of a mesh that one material draws: its corners from `start` up to `end`. */
interface MeshPart {
  material: Material;
  start: number;
  end: number;
}

function partsOf({ geometry, material }: Mesh): MeshPart[] {
  const { index, attributes, drawRange, groups } = geometry;
  const count = (index ?? attributes.position)?.count ?? 0;
  const [first, last] = [drawRange.start, Math.min(count, drawRange.start + drawRange.count)];
  const parts = Array.isArray(material)
    ? groups.map(({ start, count: size, materialIndex = 0 }) => ({
        material: material[materialIndex],
        start: Math.max(first, start),
        end: Math.min(last, start + size),
      }))
    : [{ material, start: first, end: last }];
  return parts.filter((part) => part.material?.visible && part.end - part.start >= 3);
}

function cornersOf({ geometry: { index } }: Mesh, start: number, end: number): Uint32Array {
  const count = 3 * Math.floor((end - start) / 3);
  return Uint32Array.from({ length: count }, (_, c) => (index ? index.getX(start + c) : start + c));
}
