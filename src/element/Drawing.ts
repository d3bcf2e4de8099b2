import {
  Box3,
  type BufferGeometry,
  type Color,
  DirectionalLight,
  Group,
  type InstancedMesh,
  type Light,
  type Material,
  MathUtils,
  type Mesh,
  type MeshPhysicalMaterial,
  type Object3D,
  OrthographicCamera,
  PerspectiveCamera,
  Scene,
  Spherical,
  Vector3,
} from 'three';
import { applyHatching, flatteringLight, type HatchedScene, type HatchingPreset } from 'three-hatching';
import type { ModelSource } from './decoders.js';
import { chosenIndex, disposeModel, loadModel } from './loadModel.js';
import type { Direction } from './readAttributes.js';

/** The distance of the light, in radii of the model: farther than everything that casts shadows. */
const LIGHT_DISTANCE = 3;
const SHADOW = { reach: 1.05, near: 1, far: 5, mapSize: 2048, normalBias: 0.02 } as const;
const FIELD_OF_VIEW = 30;
const NEAR = 0.05;
const FAR = 40;
/** The share of the picture's width or height that the model fills. */
const FILL = 0.94;

const place = new Vector3();
const before = new Vector3();

/** A hatched model with its light and camera. It is scaled to a radius of 1 around the origin. */
export class Drawing {
  readonly scene = new Scene();
  /** The camera in use: that of the file, or one that orbits the model. */
  camera: PerspectiveCamera | OrthographicCamera;
  private readonly around = new PerspectiveCamera(FIELD_OF_VIEW, 1, NEAR, FAR);
  private readonly light = new DirectionalLight(0xffffff, Math.PI);
  private readonly extent: Extent;

  private constructor(
    private readonly model: Object3D,
    private readonly hatched: HatchedScene,
    private readonly ofFile: FileCamera | undefined,
  ) {
    this.camera = this.around;
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
    this.scene.updateMatrixWorld();
    // The lights of the file are replaced by one light that can be moved.
    for (const light of lightsIn(model)) light.visible = false;
  }

  /**
   * Loads a model and hatches it.
   *
   * @param camera a camera of the file: a name, or a number from 1 on; '' for none
   * @param invalidate called when a frame must be drawn because lines change by themselves
   * @throws Error whose message is a sentence for the reader of the page; the signal's reason when aborted
   */
  static async load(
    source: ModelSource,
    preset: HatchingPreset,
    camera: string,
    signal: AbortSignal,
    invalidate: () => void,
  ): Promise<Drawing> {
    const { scene: model, cameras } = await loadModel(source);
    try {
      signal.throwIfAborted();
      const names = cameras.map((one) => one.names);
      const ofFile = camera ? cameras[chosenIndex('camera', names, camera)].camera : undefined;
      model.traverse((object) => {
        object.receiveShadow = true;
        // Glass casts no shadow.
        const { material } = object as Partial<Mesh<BufferGeometry, MeshPhysicalMaterial>>;
        object.castShadow = !material?.transmission && !(material?.transparent && material.opacity < 1);
      });
      const hatched = await applyHatching(model, { ...preset, signal, invalidate });
      return new Drawing(model, hatched, ofFile);
    } catch (error) {
      disposeModel(model);
      throw error;
    }
  }

  get paper(): Color {
    return this.hatched.background;
  }

  /** Draws with another preset, once everything for it is ready. @throws the signal's reason when aborted */
  async setPreset(preset: HatchingPreset, signal: AbortSignal): Promise<void> {
    await this.hatched.setPreset(preset, { signal });
  }

  /**
   * The direction to the brightest light of the file or, without lights, to one that suits the first view. @param aspect width of the
   * picture divided by its height
   */
  lightFor(eye: Direction, aspect: number): Direction {
    this.lookFirst(eye, aspect);
    return directionOf(brightest(lightsIn(this.model)) ?? flatteringLight(this.model, this.camera).direction);
  }

  /** The direction from the model to the selected camera of the file, if any. */
  get firstEye(): Direction | undefined {
    return this.ofFile && directionOf(place.setFromMatrixPosition(this.ofFile.matrixWorld));
  }

  /**
   * Sets the positions of light and camera.
   *
   * @param isFirst whether nobody has turned or zoomed: then the selected camera of the file is used, if any
   * @param zoom 1 makes the model just fill the picture, 2 makes it twice as large
   * @param aspect width of the picture divided by its height
   */
  arrange(light: Direction, eye: Direction, zoom: number, aspect: number, isFirst: boolean): void {
    before.copy(this.light.position);
    putAt(this.light.position, light, LIGHT_DISTANCE);
    if (!this.light.position.equals(before)) this.renewShadow();
    if (isFirst) this.lookFirst(eye, aspect);
    else this.look(eye, zoom, aspect);
  }

  private lookFirst(eye: Direction, aspect: number): void {
    if (this.ofFile) this.camera = cameraOf(this.ofFile, aspect);
    else this.look(eye, 1, aspect);
  }

  private look(eye: Direction, zoom: number, aspect: number): void {
    const { around: camera } = this;
    this.camera = camera;
    putAt(camera.position, eye, this.distance(MathUtils.degToRad(eye.elevation), aspect) / zoom);
    camera.lookAt(0, 0, 0);
    camera.aspect = aspect;
    camera.updateProjectionMatrix();
  }

  /** Makes the next frame draw the shadow map again. Must also be called after a lost graphics context. */
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

type FileCamera = PerspectiveCamera | OrthographicCamera;

/** A copy of a file's camera for a picture of another aspect ratio, which shows at least the camera's own picture. */
function cameraOf(source: FileCamera, aspect: number): FileCamera {
  const scale = source.matrixWorld.getMaxScaleOnAxis();
  const isFlat = 'isOrthographicCamera' in source;
  const high = isFlat ? (scale * (source.top - source.bottom)) / 2 : Math.tan(MathUtils.degToRad(source.fov) / 2);
  const own = isFlat ? (source.right - source.left) / (source.top - source.bottom) : source.aspect;
  const half = Math.max(high, (high * own) / aspect);
  const camera = isFlat
    ? new OrthographicCamera(-half * aspect, half * aspect, half, -half, NEAR, FAR)
    : new PerspectiveCamera(2 * MathUtils.radToDeg(Math.atan(half)), aspect, NEAR, FAR);
  source.matrixWorld.decompose(camera.position, camera.quaternion, place);
  return camera;
}

function lightsIn(model: Object3D): Light[] {
  const lights: Light[] = [];
  model.traverse((object) => {
    if ('isLight' in object) lights.push(object as Light);
  });
  return lights;
}

/** The direction to the light with the greatest intensity in the middle of the model; undefined without lights. */
function brightest(lights: readonly Light[]): Vector3 | undefined {
  let most = 0;
  let found: Vector3 | undefined;
  for (const light of lights) {
    const towards = new Vector3().setFromMatrixPosition(light.matrixWorld);
    const isFar = 'isDirectionalLight' in light;
    if (isFar) towards.sub(place.setFromMatrixPosition((light as DirectionalLight).target.matrixWorld));
    const arriving = light.intensity / (isFar ? 1 : towards.lengthSq());
    if (!(arriving > most && towards.lengthSq() > 0)) continue;
    most = arriving;
    found = towards;
  }
  return found;
}

function directionOf(towards: Vector3): Direction {
  const { theta, phi } = new Spherical().setFromVector3(towards);
  return { azimuth: MathUtils.radToDeg(theta), elevation: 90 - MathUtils.radToDeg(phi) };
}

function putAt(position: Vector3, { azimuth, elevation }: Direction, distance: number): void {
  position.setFromSphericalCoords(distance, MathUtils.degToRad(90 - elevation), MathUtils.degToRad(azimuth));
}

/** Puts the model into a group that moves its middle to the origin and scales its farthest point to a distance of 1. */
function fitted(model: Object3D, { middle, radius }: Extent): Group {
  const inner = new Group().add(model);
  inner.position.copy(middle).negate();
  const outer = new Group().add(inner);
  outer.scale.setScalar(1 / radius);
  return outer;
}

/** The extent of the visible parts of a model. */
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

/** The opacity below which a surface is invisible. */
const LEAST = 0.02;

const box = new Box3();
/** The extent of the visible parts: hidden and transparent ones do not count, unless there are no others. */
function extentOf(model: Object3D): Extent {
  const all = model.getObjectsByProperty('isMesh', true) as Mesh[];
  const drawn = all.map(drawnOf);
  const seen = drawn.filter(({ vertices }) => vertices.includes(1));
  const parts = seen.length > 0 ? seen : all.map((mesh) => ({ mesh, vertices: everyVertex(mesh) }));
  box.makeEmpty();
  for (const { mesh, vertices } of parts) {
    if (isInstanced(mesh)) {
      if (!mesh.boundingBox) mesh.computeBoundingBox();
      box.union(new Box3().copy(mesh.boundingBox!).applyMatrix4(mesh.matrixWorld));
    } else eachPoint(mesh, vertices, (point) => box.expandByPoint(point));
  }
  const middle = box.getCenter(new Vector3());
  const size = box.getSize(place);
  const height = size.y / 2;
  // For instances only the bounding box is known.
  let [radius, around] = [size.length() / 2, Math.hypot(size.x, size.z) / 2];
  if (!parts.some(({ mesh }) => isInstanced(mesh))) {
    [radius, around] = [0, 0];
    for (const { mesh, vertices } of parts) {
      eachPoint(mesh, vertices, (point) => {
        point.sub(middle);
        radius = Math.max(radius, point.length());
        around = Math.max(around, Math.hypot(point.x, point.z));
      });
    }
  }
  const unit = radius > 0 && radius < Infinity ? radius : 1;
  return { middle, radius: unit, around: around / unit, height: height / unit };
}

/** @param call receives each marked and finite vertex of a mesh in its present pose, in world space. It may change the point */
function eachPoint(mesh: Mesh, vertices: Uint8Array, call: (point: Vector3) => void): void {
  const point = new Vector3();
  for (let i = 0; i < vertices.length; i++) {
    if (vertices[i] === 0) continue;
    mesh.getVertexPosition(i, point).applyMatrix4(mesh.matrixWorld);
    if (Number.isFinite(point.x + point.y + point.z)) call(point);
  }
}

/** Marks the vertices of the visible parts of a mesh. */
function drawnOf(mesh: Mesh): { mesh: Mesh; vertices: Uint8Array } {
  const { geometry, material } = mesh;
  const { index, groups } = geometry;
  const vertices = everyVertex(mesh).fill(0);
  const ranges = Array.isArray(material)
    ? groups.map(({ start, count, materialIndex = 0 }) => ({ start, count, material: material[materialIndex] }))
    : [{ start: 0, count: Infinity, material }];
  for (const { start, count, material: one } of isShown(mesh) ? ranges : []) {
    if (!one || isClear(one)) continue;
    const end = Math.min(start + count, index?.count ?? vertices.length);
    for (let corner = start; corner < end; corner++) vertices[index ? index.getX(corner) : corner] = 1;
  }
  return { mesh, vertices };
}

const everyVertex = ({ geometry }: Mesh): Uint8Array =>
  new Uint8Array(geometry.getAttribute('position')?.count ?? 0).fill(1);

const isInstanced = (mesh: Mesh): mesh is InstancedMesh => 'isInstancedMesh' in mesh;

function isShown(mesh: Mesh): boolean {
  for (let object: Object3D | null = mesh; object; object = object.parent) if (!object.visible) return false;
  return true;
}

const isClear = ({ visible, transparent, opacity, alphaTest }: Material): boolean =>
  !visible || (transparent && opacity < LEAST) || opacity < alphaTest;
