import {
  type Camera,
  DirectionalLight,
  type Light,
  MathUtils,
  PointLight,
  type Scene,
  SpotLight,
  Vector3,
} from 'three';
import type { Settings } from '../settings/settings.js';
import { SECOND_LIGHT_AZIMUTH } from '../settings/settingValues.js';

/** Distance at which the handle of a directional light is shown, in radii of the model. */
const SUN_DISTANCE = 1.45;

/** The shadows of a model of radius 1 around the origin, from a light that lies outside. */
const REACH = 1.05;
const SHADOW_NEAR = 0.05;
const SHADOW_FAR = 7;
const SHADOW_MAP_SIZE = 2048;
/** In units of the model. */
const SHADOW_NORMAL_BIAS = 0.02;
/** In texels. */
const SHADOW_SOFTNESS = 1;

const before = new Vector3();

/** The lights of the scene: the main light, of one of three kinds, and a second sun at a fixed angle from it. */
export class LightRig {
  /** The position of the main light, in world coordinates. The model's centre is the origin. */
  readonly position = new Vector3();
  private readonly lights: Record<Settings['lightKind'], Light>;
  private readonly second = new DirectionalLight();

  constructor(scene: Scene) {
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
    const spot = this.lights.spot as SpotLight;
    spot.angle = MathUtils.degToRad(settings.spotAngle) / 2;
    spot.penumbra = settings.spotSoftness / 100;
    this.second.visible = settings.secondLight !== 'none';
    this.second.castShadow = settings.shadows === 'on';
    this.second.intensity = (Math.PI * settings.secondStrength) / 100;
  }

  /**
   * Places the lights.
   *
   * @param viewer that the light stays with, if the settings say so
   * @returns whether one has moved
   */
  place(settings: Settings, { quaternion }: Camera): boolean {
    const { lightFollows, lightKind, secondLight } = settings;
    const azimuth = MathUtils.degToRad(settings.lightAzimuth);
    const elevation = MathUtils.degToRad(settings.lightElevation);
    const around = secondLight === 'none' ? 0 : MathUtils.degToRad(SECOND_LIGHT_AZIMUTH[secondLight]);
    const distance = lightKind === 'directional' ? SUN_DISTANCE : settings.lightDistance;
    before.copy(this.position);
    this.position.setFromSphericalCoords(distance, Math.PI / 2 - elevation, azimuth);
    this.second.position.setFromSphericalCoords(SUN_DISTANCE, Math.PI / 2 - elevation, azimuth + around);
    if (lightFollows === 'viewer') {
      this.position.applyQuaternion(quaternion);
      this.second.position.applyQuaternion(quaternion);
    }
    for (const kind in this.lights) this.lights[kind as Settings['lightKind']].position.copy(this.position);
    return !before.equals(this.position);
  }
}
