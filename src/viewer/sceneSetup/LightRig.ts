import {
  type Camera,
  DirectionalLight,
  MathUtils,
  Matrix4,
  type OrthographicCamera,
  type PerspectiveCamera,
  PointLight,
  type Scene,
  SpotLight,
  Vector3,
} from 'three';
import type { Lighting } from '../settings/lookOf.js';
import type { LightPlace } from '../settings/settingValues.js';
import { fadeOnSheet, type GroundLight, type SheetPart, shadowOnGround } from './groundShadow.js';

/** Distance of a directional light, in radii of the model: outside all casters of shadows. */
export const SUN_DISTANCE = 1.45;

/** Shadow settings for a model of radius 1 around the origin and a light outside it. Softness is in texels. */
export const SHADOWS = { reach: 1.05, near: 0.05, far: 7, mapSize: 2048, normalBias: 0.02, softness: 1 } as const;
/** Resolution of shadow maps: coarse while something moves on a slow machine, fine for pictures larger than a screen. */
const SHADOW_MAP_SIZES = { coarse: 1024, usual: SHADOWS.mapSize, fine: 4096 } as const;
export type ShadowQuality = keyof typeof SHADOW_MAP_SIZES;

type CastingLight = DirectionalLight | PointLight | SpotLight;

const ORIGIN = new Vector3();
const UP = new Vector3(0, 1, 0);
const before = new Vector3();
const secondBefore = new Vector3();

/** The lights of the scene: a main light of one of three kinds, and a second sun. */
export class LightRig {
  /** The position of the main light, in world coordinates. The model's centre is the origin. */
  readonly position = new Vector3();
  /** The position of the second sun. */
  readonly secondPosition: Vector3;
  private readonly second = new DirectionalLight();
  private readonly main: Record<Lighting['kind'], CastingLight>;
  private readonly spot = new SpotLight();
  private readonly all: readonly CastingLight[];
  /** Position by the settings, before the lights follow the viewer. */
  private readonly settled = new Vector3();
  private readonly secondSettled = new Vector3(0, SUN_DISTANCE, 0);
  private isWithViewer = false;
  private readonly groundLight: GroundLight = {
    position: this.position,
    isSun: true,
    widthAt: (place) => this.shadowWidth(place),
  };
  private readonly secondGroundLight: GroundLight;
  private mapSize: number = SHADOWS.mapSize;

  constructor(scene: Scene) {
    this.secondPosition = this.second.position;
    this.secondGroundLight = { position: this.secondPosition, isSun: true, widthAt: () => 2 * SHADOWS.reach };
    const sun = new DirectionalLight();
    const point = new PointLight();
    // Without decay, moving the light turns the strokes and does not change the exposure.
    point.decay = 0;
    this.spot.decay = 0;
    this.main = { directional: sun, point, spot: this.spot };
    this.all = [sun, point, this.spot, this.second];
    for (const { shadow } of [sun, this.second]) {
      const { reach } = SHADOWS;
      Object.assign(shadow.camera, { left: -reach, right: reach, bottom: -reach, top: reach });
    }
    for (const { shadow } of this.all) {
      Object.assign(shadow.camera, { near: SHADOWS.near, far: SHADOWS.far });
      shadow.mapSize.setScalar(SHADOWS.mapSize);
      shadow.normalBias = SHADOWS.normalBias;
      shadow.radius = SHADOWS.softness;
    }
    scene.add(...this.all);
  }

  /** Applies a look's lighting. */
  apply({ kind, place, intensity, spotAngle, spotPenumbra, second, castsShadows, isWithViewer }: Lighting): void {
    for (const light of this.all) light.castShadow = castsShadows;
    for (const [name, light] of Object.entries(this.main)) {
      light.visible = name === kind;
      light.intensity = intensity;
    }
    this.spot.angle = spotAngle;
    this.spot.penumbra = spotPenumbra;
    setPosition(this.settled, place);
    this.second.visible = second !== undefined;
    if (second) {
      this.second.intensity = second.intensity;
      setPosition(this.secondSettled, second.place);
    }
    this.isWithViewer = isWithViewer;
  }

  /**
   * Sets the quality of shadows. Coarse ones take one sample instead of nine; shadow maps are resized only when they are redrawn anyway,
   * since redrawing a large model takes as long as a frame. Builds no program.
   *
   * @param areDrawn whether the shadow maps are redrawn in any case
   * @returns whether the shadow maps must be redrawn
   */
  setShadowQuality(quality: ShadowQuality, areDrawn: boolean): boolean {
    const radius = quality === 'coarse' ? 0 : SHADOWS.softness;
    for (const { shadow } of this.all) shadow.radius = radius;
    const mapSize = SHADOW_MAP_SIZES[quality];
    if (mapSize === this.mapSize || (quality === 'coarse' && !areDrawn)) return false;
    this.mapSize = mapSize;
    for (const { shadow } of this.all) {
      // three does not resize the cube of a point light.
      if (shadow !== this.main.point.shadow) shadow.mapSize.setScalar(mapSize);
    }
    return this.second.castShadow;
  }

  /** Requests that shadow maps be redrawn in the next frame, and only then: WebGPURenderer asks each light. */
  outdateShadows(): void {
    for (const { shadow } of this.all) {
      shadow.autoUpdate = false;
      shadow.needsUpdate = true;
    }
  }

  /**
   * The shadows of points on level ground cast by the main light, as in {@link shadowOnGround}.
   *
   * @param toEye direction to the viewer, whom a light may follow
   * @param up up direction of the viewer's picture
   * @returns undefined if it casts none
   */
  shadowOf(points: ArrayLike<number>, height: number, toEye: Vector3, up: Vector3 = UP): number[] | undefined {
    const { shining } = this;
    if (!shining) return undefined;
    const position = this.settled.clone();
    if (this.isWithViewer) position.applyMatrix4(new Matrix4().lookAt(toEye, ORIGIN, up));
    return shadowOnGround(points, position, shining === this.main.directional, height);
  }

  /** The fading that ends the shadows of all lights on the sheet, from {@link fadeOnSheet}. The lights must be placed. */
  fadeOf(
    casters: ArrayLike<number>,
    height: number,
    camera: PerspectiveCamera | OrthographicCamera,
    part: SheetPart,
  ): number {
    const { shining, second, groundLight, secondGroundLight } = this;
    if (!shining) return 0;
    groundLight.isSun = shining === this.main.directional;
    const fade = fadeOnSheet(casters, height, groundLight, camera, part);
    return second.visible ? Math.max(fade, fadeOnSheet(casters, height, secondGroundLight, camera, part)) : fade;
  }

  /** The main light, if it casts shadows. */
  private get shining(): CastingLight | undefined {
    for (const kind in this.main) {
      const light = this.main[kind as Lighting['kind']];
      if (light.visible) return light.castShadow ? light : undefined;
    }
    return undefined;
  }

  /** The width at a place, across the light, that the main light's shadow camera sees. */
  private shadowWidth({ x, y, z }: Vector3): number {
    const { main, position, spot } = this;
    if (main.directional.visible) return 2 * SHADOWS.reach;
    const [dx, dy, dz] = [x - position.x, y - position.y, z - position.z];
    if (main.point.visible) return 2 * Math.max(Math.abs(dx), Math.abs(dy), Math.abs(dz));
    // The light aims at the middle of the model.
    const along = -(dx * position.x + dy * position.y + dz * position.z) / position.length();
    return 2 * Math.tan(spot.angle) * along;
  }

  /**
   * Places the lights by the settings. Allocates nothing.
   *
   * @param viewer the camera that lights follow, if the settings ask for it
   * @returns whether a light has moved
   */
  place({ quaternion }: Camera): boolean {
    before.copy(this.position);
    secondBefore.copy(this.secondPosition);
    this.position.copy(this.settled);
    this.secondPosition.copy(this.secondSettled);
    if (this.isWithViewer) {
      this.position.applyQuaternion(quaternion);
      this.secondPosition.applyQuaternion(quaternion);
    }
    for (const kind in this.main) this.main[kind as Lighting['kind']].position.copy(this.position);
    return !before.equals(this.position) || !secondBefore.equals(this.secondPosition);
  }
}

function setPosition(position: Vector3, { azimuth, elevation, distance = SUN_DISTANCE }: LightPlace): void {
  position.setFromSphericalCoords(distance, MathUtils.degToRad(90 - elevation), MathUtils.degToRad(azimuth));
}
