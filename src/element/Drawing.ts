import {
  Box3,
  type ColorRepresentation,
  DirectionalLight,
  Group,
  type InstancedMesh,
  type Material,
  MathUtils,
  type Mesh,
  type MeshPhysicalMaterial,
  type Object3D,
  PerspectiveCamera,
  Scene,
  Spherical,
  Vector3,
} from 'three';
import { applyHatching, flatteringLight, type HatchedScene, type HatchingPreset } from 'three-hatching';
import { disposeModel, loadModel } from './loadModel.js';
import type { ModelSource } from './ModelSource.js';
import type { Direction } from './readAttributes.js';

/** The distance of the light, in radii of the model: outside of everything that casts shadows. */
const LIGHT_DISTANCE = 3;
const SHADOW = { reach: 1.05, near: 1, far: 5, mapSize: 2048, normalBias: 0.02 } as const;
const FIELD_OF_VIEW = 30;
/** The share of the picture that the model fills, of its width or its height. */
const FILL = 0.94;

const box = new Box3();
const place = new Vector3();
const before = new Vector3();

/** A hatched model with its light and camera. It is scaled to a radius of 1 around the origin. */
export class Drawing {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.05, 40);
  private readonly light = new DirectionalLight(0xffffff, Math.PI);
  private readonly extent: Extent;

  private constructor(
    private readonly model: Object3D,
    private readonly preset: HatchingPreset,
    private readonly hatched: HatchedScene,
  ) {
    const { shadow } = this.light;
    const { reach, near, far, mapSize, normalBias } = SHADOW;
    this.light.castShadow = true;
    Object.assign(shadow.camera, { left: -reach, right: reach, bottom: -reach, top: reach, near, far });
    shadow.mapSize.set(mapSize, mapSize);
    shadow.normalBias = normalBias;
    // The shadow map is drawn again when the light moves, but not when the camera does.
    shadow.autoUpdate = false;
    this.extent = extentOf(model);
    this.scene.add(fitted(model, this.extent), this.light);
  }

  /**
   * Loads a model and hatches it.
   *
   * @param invalidate called when a frame is to be drawn because lines change by themselves
   * @throws Error whose message is a sentence for the reader of the page; the signal's reason when aborted
   */
  static async load(
    source: ModelSource,
    preset: HatchingPreset,
    signal: AbortSignal,
    invalidate: () => void,
  ): Promise<Drawing> {
    const model = await loadModel(source);
    try {
      signal.throwIfAborted();
      model.traverse((object) => {
        object.receiveShadow = true;
        object.castShadow = !isSeenThrough(object as Mesh);
      });
      const hatched = await applyHatching(model, { ...preset, signal, invalidate });
      return new Drawing(model, preset, hatched);
    } catch (error) {
      disposeModel(model);
      throw error;
    }
  }

  get paper(): ColorRepresentation {
    return this.preset.material.paper ?? 'white';
  }

  /** The direction to a light that suits a view of the whole model. @param aspect width of the picture divided by its height */
  lightFor(eye: Direction, aspect: number): Direction {
    this.look(eye, 1, aspect);
    const { theta, phi } = new Spherical().setFromVector3(flatteringLight(this.model, this.camera).direction);
    return { azimuth: MathUtils.radToDeg(theta), elevation: 90 - MathUtils.radToDeg(phi) };
  }

  /**
   * Sets the positions of light and camera.
   *
   * @param zoom 1 makes the model just fill the picture, 2 makes it twice as large
   * @param aspect width of the picture divided by its height
   */
  arrange(light: Direction, eye: Direction, zoom: number, aspect: number): void {
    before.copy(this.light.position);
    putAt(this.light.position, light, LIGHT_DISTANCE);
    if (!this.light.position.equals(before)) this.renewShadow();
    this.look(eye, zoom, aspect);
  }

  private look(eye: Direction, zoom: number, aspect: number): void {
    const { camera } = this;
    putAt(camera.position, eye, this.distance(MathUtils.degToRad(eye.elevation), aspect) / zoom);
    camera.lookAt(0, 0, 0);
    camera.aspect = aspect;
    camera.updateProjectionMatrix();
  }

  /** Makes the next frame draw the shadow map again. Call it after a lost graphics context too. */
  renewShadow(): void {
    this.light.shadow.needsUpdate = true;
  }

  /** The distance at which the model fills the picture, however it is turned about its vertical axis. */
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
    disposeModel(this.model);
    this.light.dispose();
  }
}

/** Whether a mesh lets light through, so that it casts no shadow. */
const isSeenThrough = ({ material }: Mesh): boolean =>
  [material ?? []]
    .flat()
    .some(({ transparent, opacity, transmission = 0 }: MaybeGlass) => (transparent && opacity < 1) || transmission > 0);

type MaybeGlass = Pick<Material, 'transparent' | 'opacity'> & Partial<Pick<MeshPhysicalMaterial, 'transmission'>>;

function putAt(position: Vector3, { azimuth, elevation }: Direction, distance: number): void {
  position.setFromSphericalCoords(distance, MathUtils.degToRad(90 - elevation), MathUtils.degToRad(azimuth));
}

/** The extent of a model. */
interface Extent {
  /** The centre of the bounding box, in the units of the model. */
  middle: Vector3;
  /** The distance of the farthest point from the middle, in the units of the model. */
  radius: number;
  /** The distance of the farthest point from the vertical axis through the middle, in radii. */
  around: number;
  /** Half the height of the bounding box, in radii. */
  height: number;
}

/** Puts the model into a group that moves its middle to the origin and scales its farthest point to a distance of 1. */
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
  // For instances only the bounding box is known.
  const [radius, around] = farthest(model, middle) ?? [place.length() / 2, Math.hypot(place.x, place.z) / 2];
  const unit = radius > 0 && radius < Infinity ? radius : 1;
  return { middle, radius: unit, around: around / unit, height: height / unit };
}

/** The greatest distances of a model's points from a place and from the vertical line through it; undefined if there are instances. */
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
