import {
  Box3,
  type ColorRepresentation,
  DirectionalLight,
  Group,
  type InstancedMesh,
  MathUtils,
  type Mesh,
  type Object3D,
  PerspectiveCamera,
  Scene,
  Vector3,
} from 'three';
import {
  applyHatching,
  type HatchedScene,
  type HatchingPreset,
  type MapDrawing,
  needsMap,
  scalePreset,
  TonalArtMap,
} from 'three-hatching';
import { disposeModel, loadModel } from './loadModel.js';
import type { ModelSource } from './ModelSource.js';
import type { Direction } from './readAttributes.js';
import { SharedResources } from './SharedResources.js';

/** The distance of the light, in radii of the model: outside of what casts shadows. */
const LIGHT_DISTANCE = 3;
const SHADOW = { reach: 1.05, near: 1, far: 5, mapSize: 2048, normalBias: 0.02 } as const;
const FIELD_OF_VIEW = 30;
/** The share of the picture that the model fills, of its width or its height. */
const FILL = 0.94;

const box = new Box3();
const place = new Vector3();
const before = new Vector3();

/** The maps of presets, by how they are drawn: presets are frozen, so that is the same object every time. */
const maps = new SharedResources<Readonly<MapDrawing>, TonalArtMap>();
const DEFAULT_MAP: Readonly<MapDrawing> = {};

/** How the map of a preset is drawn; null if it needs none. */
const mapOf = ({ material, tonalArtMap }: HatchingPreset): Readonly<MapDrawing> | null =>
  needsMap(material) ? (tonalArtMap ?? DEFAULT_MAP) : null;

/** A hatched model with its light and its viewer. It is scaled to a radius of 1 around the origin. */
export class Drawing {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.05, 40);
  private readonly light = new DirectionalLight(0xffffff, Math.PI);
  private readonly extent: Extent;

  private constructor(
    private readonly model: Object3D,
    private readonly preset: HatchingPreset,
    private readonly hatched: HatchedScene,
    private pixelRatio: number,
  ) {
    const { shadow } = this.light;
    const { reach, near, far, mapSize, normalBias } = SHADOW;
    this.light.castShadow = true;
    Object.assign(shadow.camera, { left: -reach, right: reach, bottom: -reach, top: reach, near, far });
    shadow.mapSize.set(mapSize, mapSize);
    shadow.normalBias = normalBias;
    // Drawn again when the light moves, not when the viewer does.
    shadow.autoUpdate = false;
    this.extent = extentOf(model);
    this.scene.add(fitted(model, this.extent), this.light);
  }

  /**
   * Loads a model and hatches it.
   *
   * @param pixelRatio pixels of the canvas per CSS pixel
   * @throws Error with a sentence for the reader of the page; the signal's reason if it aborts
   */
  static async load(
    source: ModelSource,
    preset: HatchingPreset,
    pixelRatio: number,
    signal: AbortSignal,
  ): Promise<Drawing> {
    const model = await loadModel(source);
    const strokes = mapOf(preset);
    let borrowed = false;
    try {
      signal.throwIfAborted();
      model.traverse((object) => {
        object.castShadow = object.receiveShadow = true;
      });
      borrowed = strokes !== null;
      const tonalArtMap = strokes && (await maps.borrow(strokes, () => TonalArtMap.generate(strokes)));
      const hatched = await applyHatching(model, { ...scalePreset(preset, pixelRatio), tonalArtMap, signal });
      return new Drawing(model, preset, hatched, pixelRatio);
    } catch (error) {
      if (borrowed) maps.giveBack(strokes!);
      disposeModel(model);
      throw error;
    }
  }

  get paper(): ColorRepresentation {
    return this.preset.material.paper ?? 'white';
  }

  /** Makes strokes as wide on the screen as on any other. @param pixelRatio pixels of the canvas per CSS pixel */
  setPixelRatio(pixelRatio: number): void {
    if (pixelRatio === this.pixelRatio) return;
    this.pixelRatio = pixelRatio;
    const { material, lines } = scalePreset(this.preset, pixelRatio);
    for (const one of this.hatched.materials) one.setValues(material);
    for (const one of this.hatched.lines) one.material.setValues(lines);
  }

  /**
   * Sets where light and viewer are.
   *
   * @param zoom how many times larger the model is seen than one that just fills the picture
   * @param aspect width of the picture divided by its height
   */
  arrange(light: Direction, eye: Direction, zoom: number, aspect: number): void {
    const { camera } = this;
    before.copy(this.light.position);
    putAt(this.light.position, light, LIGHT_DISTANCE);
    if (!this.light.position.equals(before)) this.renewShadow();
    putAt(camera.position, eye, this.distance(MathUtils.degToRad(eye.elevation), aspect) / zoom);
    camera.lookAt(0, 0, 0);
    camera.aspect = aspect;
    camera.updateProjectionMatrix();
  }

  /** Has the shadow drawn again with the next frame. To be called when the graphics context was lost, too. */
  renewShadow(): void {
    this.light.shadow.needsUpdate = true;
  }

  /** From where the model fills the picture, whichever way it is turned about its upright axis. */
  private distance(elevation: number, aspect: number): number {
    const { around, height } = this.extent;
    const slopeY = Math.tan(MathUtils.degToRad(FIELD_OF_VIEW / 2)) * FILL;
    const slopeX = slopeY * aspect;
    const forBall = 1 / Math.sin(Math.atan(Math.min(slopeX, slopeY)));
    const forWidth = around / Math.sin(Math.atan(slopeX));
    const forHeight = around + (height * Math.cos(elevation) + around * Math.abs(Math.sin(elevation))) / slopeY;
    return Math.min(forBall, Math.max(forWidth, forHeight));
  }

  dispose(): void {
    this.hatched.dispose();
    const strokes = mapOf(this.preset);
    if (strokes) maps.giveBack(strokes);
    disposeModel(this.model);
    this.light.dispose();
  }
}

function putAt(position: Vector3, { azimuth, elevation }: Direction, distance: number): void {
  position.setFromSphericalCoords(distance, MathUtils.degToRad(90 - elevation), MathUtils.degToRad(azimuth));
}

/** How far a model reaches from its middle. All but the middle in units of the radius. */
interface Extent {
  middle: Vector3;
  /** Of the farthest point, in the units of the model. */
  radius: number;
  /** From the upright axis. */
  around: number;
  /** Up and down. */
  height: number;
}

/** The model in a group that moves its middle to the origin and scales its farthest point to a distance of 1. */
function fitted(model: Object3D, { middle, radius }: Extent): Group {
  const inner = new Group().add(model);
  inner.position.copy(middle).negate();
  const outer = new Group().add(inner);
  outer.scale.setScalar(1 / radius);
  return outer;
}

function extentOf(model: Object3D): Extent {
  const middle = box.setFromObject(model, true).getCenter(new Vector3());
  const height = box.getSize(place).y / 2;
  // Of instances the box is known, and no more.
  const [radius, around] = farthest(model, middle) ?? [place.length() / 2, Math.hypot(place.x, place.z) / 2];
  const unit = radius > 0 && radius < Infinity ? radius : 1;
  return { middle, radius: unit, around: around / unit, height: height / unit };
}

/** How far the farthest points of a model are from a place, and from the upright line through it; undefined if there are instances. */
function farthest(model: Object3D, from: Vector3): [radius: number, around: number] | undefined {
  let radius = 0;
  let around = 0;
  let hasInstances = false;
  const point = new Vector3();
  model.traverse((object) => {
    const { isMesh, isInstancedMesh, geometry } = object as Mesh & Partial<InstancedMesh>;
    if (!isMesh) return;
    hasInstances ||= isInstancedMesh === true;
    const count = geometry.attributes.position?.count ?? 0;
    for (let i = 0; i < count; i++) {
      (object as Mesh).getVertexPosition(i, point).applyMatrix4(object.matrixWorld).sub(from);
      radius = Math.max(radius, point.length());
      around = Math.max(around, Math.hypot(point.x, point.z));
    }
  });
  return hasInstances ? undefined : [radius, around];
}
