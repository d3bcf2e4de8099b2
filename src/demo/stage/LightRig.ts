import { type Camera, DirectionalLight, MathUtils, PointLight, type Scene, SpotLight, Vector3 } from 'three';
import type { Settings } from '../settings/settings.js';
import { type LightPlace, placeOfLight, placeOfSecondLight } from '../settings/settingValues.js';

/** Distance of a directional light, in radii of the model: outside of what casts shadows. */
const SUN_DISTANCE = 1.45;

/** The shadows of a model of radius 1 around the origin, from a light that lies outside. */
const REACH = 1.05;
const SHADOW_NEAR = 0.05;
const SHADOW_FAR = 7;
const SHADOW_MAP_SIZE = 2048;
/** While something moves on a slow machine. */
const COARSE_SHADOW_MAP_SIZE = 1024;
/** In units of the model. */
const SHADOW_NORMAL_BIAS = 0.02;
/** In texels. */
const SHADOW_SOFTNESS = 1;

type CastingLight = DirectionalLight | PointLight | SpotLight;

const before = new Vector3();
const secondBefore = new Vector3();

/** The lights of the scene: the main light, of one of three kinds, and a second sun. */
export class LightRig {
  /** The position of the main light, in world coordinates. The model's centre is the origin. */
  readonly position = new Vector3();
  /** The position of the second sun. */
  readonly secondPosition: Vector3;
  private readonly second = new DirectionalLight();
  private readonly main: Record<Settings['lightKind'], CastingLight>;
  private readonly spot = new SpotLight();
  private readonly all: readonly CastingLight[];
  /** Where the settings put the lights, before they go with the viewer. */
  private readonly settled = new Vector3();
  private readonly secondSettled = new Vector3(0, SUN_DISTANCE, 0);
  private isWithViewer = false;
  private isCoarse = false;

  constructor(scene: Scene) {
    this.secondPosition = this.second.position;
    const sun = new DirectionalLight();
    const point = new PointLight();
    // Without decay, moving the light turns the strokes and does not change the exposure.
    point.decay = 0;
    this.spot.decay = 0;
    this.main = { directional: sun, point, spot: this.spot };
    this.all = [sun, point, this.spot, this.second];
    for (const { shadow } of [sun, this.second]) {
      Object.assign(shadow.camera, { left: -REACH, right: REACH, bottom: -REACH, top: REACH });
    }
    for (const { shadow } of this.all) {
      Object.assign(shadow.camera, { near: SHADOW_NEAR, far: SHADOW_FAR });
      shadow.mapSize.setScalar(SHADOW_MAP_SIZE);
      shadow.normalBias = SHADOW_NORMAL_BIAS;
      shadow.radius = SHADOW_SOFTNESS;
    }
    scene.add(...this.all);
  }

  /** Applies the settings. */
  apply(settings: Settings): void {
    for (const light of this.all) light.castShadow = settings.shadows === 'on';
    for (const [kind, light] of Object.entries(this.main)) {
      light.visible = kind === settings.lightKind;
      // At an intensity of π, a white surface that faces the light gets tone 0: bare paper.
      light.intensity = (Math.PI * settings.lightStrength) / 100;
    }
    this.spot.angle = MathUtils.degToRad(settings.spotAngle) / 2;
    this.spot.penumbra = settings.spotSoftness / 100;
    const second = placeOfSecondLight(settings);
    this.second.visible = second !== undefined;
    this.second.intensity = (Math.PI * settings.secondStrength) / 100;
    setPosition(this.settled, placeOfLight(settings));
    if (second) setPosition(this.secondSettled, second);
    this.isWithViewer = settings.lightFollows === 'viewer';
  }

  /**
   * Lowers the quality of shadows while something moves on a slow machine: coarser maps, and one sample in the place of nine.
   * Builds no program.
   *
   * @returns whether the maps must be drawn anew
   */
  lowerShadows(isCoarse: boolean): boolean {
    if (isCoarse === this.isCoarse) return false;
    this.isCoarse = isCoarse;
    for (const { shadow } of this.all) {
      shadow.radius = isCoarse ? 0 : SHADOW_SOFTNESS;
      // three does not resize the cube of a point light.
      if (shadow !== this.main.point.shadow)
        shadow.mapSize.setScalar(isCoarse ? COARSE_SHADOW_MAP_SIZE : SHADOW_MAP_SIZE);
    }
    return this.second.castShadow;
  }

  /**
   * Places the lights where the settings put them. Allocates nothing.
   *
   * @param viewer that they stay with, if the settings say so
   * @returns whether one has moved
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
    for (const kind in this.main) this.main[kind as Settings['lightKind']].position.copy(this.position);
    return !before.equals(this.position) || !secondBefore.equals(this.secondPosition);
  }
}

function setPosition(position: Vector3, { azimuth, elevation, distance = SUN_DISTANCE }: LightPlace): void {
  position.setFromSphericalCoords(distance, MathUtils.degToRad(90 - elevation), MathUtils.degToRad(azimuth));
}
