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

const before = new Vector3();
const secondBefore = new Vector3();

/** The lights of the scene: the main light, of one of three kinds, and a second sun. */
export class LightRig {
  /** The position of the main light, in world coordinates. The model's centre is the origin. */
  readonly position = new Vector3();
  /** The position of the second sun. */
  readonly secondPosition: Vector3;
  private readonly lights: { directional: DirectionalLight; point: PointLight; spot: SpotLight };
  private readonly second = new DirectionalLight();
  private isCoarse = false;

  constructor(scene: Scene) {
    this.secondPosition = this.second.position;
    const point = new PointLight();
    const spot = new SpotLight();
    // Without decay, moving the light turns the strokes and does not change the exposure.
    point.decay = 0;
    spot.decay = 0;
    const sun = new DirectionalLight();
    for (const { shadow } of [sun, this.second]) {
      Object.assign(shadow.camera, { left: -REACH, right: REACH, bottom: -REACH, top: REACH });
    }
    for (const { shadow } of [sun, point, spot, this.second]) {
      Object.assign(shadow.camera, { near: SHADOW_NEAR, far: SHADOW_FAR });
      shadow.mapSize.setScalar(SHADOW_MAP_SIZE);
      shadow.normalBias = SHADOW_NORMAL_BIAS;
      shadow.radius = SHADOW_SOFTNESS;
    }
    this.lights = { directional: sun, point, spot };
    scene.add(this.second, ...Object.values(this.lights));
  }

  /** Applies the settings, all but the place of the lights. */
  apply(settings: Settings): void {
    for (const [kind, light] of Object.entries(this.lights)) {
      light.visible = kind === settings.lightKind;
      light.castShadow = settings.shadows === 'on';
      // At an intensity of π, a white surface that faces the light gets tone 0: bare paper.
      light.intensity = (Math.PI * settings.lightStrength) / 100;
    }
    const { spot } = this.lights;
    spot.angle = MathUtils.degToRad(settings.spotAngle) / 2;
    spot.penumbra = settings.spotSoftness / 100;
    this.second.visible = settings.secondLight !== 'none';
    this.second.castShadow = settings.shadows === 'on';
    this.second.intensity = (Math.PI * settings.secondStrength) / 100;
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
    for (const { shadow } of [this.second, ...Object.values(this.lights)] as (
      | DirectionalLight
      | PointLight
      | SpotLight
    )[]) {
      shadow.radius = isCoarse ? 0 : SHADOW_SOFTNESS;
      // three does not resize the cube of a point light.
      if (shadow !== this.lights.point.shadow)
        shadow.mapSize.setScalar(isCoarse ? COARSE_SHADOW_MAP_SIZE : SHADOW_MAP_SIZE);
    }
    return this.lights.directional.castShadow;
  }

  /**
   * Places the lights.
   *
   * @param viewer that the light stays with, if the settings say so
   * @returns whether one has moved
   */
  place(settings: Settings, { quaternion }: Camera): boolean {
    before.copy(this.position);
    secondBefore.copy(this.secondPosition);
    setPosition(this.position, placeOfLight(settings));
    const second = placeOfSecondLight(settings);
    if (second) setPosition(this.secondPosition, second);
    if (settings.lightFollows === 'viewer') {
      this.position.applyQuaternion(quaternion);
      if (second) this.secondPosition.applyQuaternion(quaternion);
    }
    for (const kind in this.lights) this.lights[kind as Settings['lightKind']].position.copy(this.position);
    return !before.equals(this.position) || !secondBefore.equals(this.secondPosition);
  }
}

function setPosition(position: Vector3, { azimuth, elevation, distance = SUN_DISTANCE }: LightPlace): void {
  position.setFromSphericalCoords(distance, MathUtils.degToRad(90 - elevation), MathUtils.degToRad(azimuth));
}
