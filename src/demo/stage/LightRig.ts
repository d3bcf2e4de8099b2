import { DirectionalLight, type Light, MathUtils, PointLight, type Scene, SpotLight, Vector3 } from 'three';
import type { Settings } from '../settings/settings.js';
import { SECOND_LIGHT_AZIMUTH } from '../settings/settingValues.js';

/** Where the handle of a light without a distance is shown, in radii of the model. */
const SUN_DISTANCE = 1.45;

/** The lights of the scene: one of three kinds at one place, and a second sun that goes round with it. */
export class LightRig {
  /** Where the light stands, in world coordinates; the model's centre is the origin. */
  readonly position = new Vector3();
  private readonly lights: Record<Settings['lightKind'], Light>;
  private readonly second = new DirectionalLight();

  constructor(scene: Scene) {
    const point = new PointLight();
    const spot = new SpotLight();
    // Strength is then the same at every distance: moving the lamp turns the strokes, not the exposure.
    point.decay = 0;
    spot.decay = 0;
    this.lights = { directional: new DirectionalLight(), point, spot };
    scene.add(this.second, ...Object.values(this.lights));
  }

  /** Puts the settings in force. */
  apply(settings: Settings): void {
    const azimuth = MathUtils.degToRad(settings.lightAzimuth);
    const elevation = MathUtils.degToRad(settings.lightElevation);
    const distance = settings.lightKind === 'directional' ? SUN_DISTANCE : settings.lightDistance;
    this.position.setFromSphericalCoords(distance, Math.PI / 2 - elevation, azimuth);
    for (const [kind, light] of Object.entries(this.lights)) {
      light.visible = kind === settings.lightKind;
      light.position.copy(this.position);
      // With an intensity of π a white surface facing the light is as light as paper.
      light.intensity = (Math.PI * settings.lightStrength) / 100;
    }
    const spot = this.lights.spot as SpotLight;
    spot.angle = MathUtils.degToRad(settings.spotAngle) / 2;
    spot.penumbra = settings.spotSoftness / 100;
    this.second.visible = settings.secondLight !== 'none';
    if (settings.secondLight !== 'none') {
      const around = azimuth + MathUtils.degToRad(SECOND_LIGHT_AZIMUTH[settings.secondLight]);
      this.second.position.setFromSphericalCoords(1, Math.PI / 2 - elevation, around);
      this.second.intensity = (Math.PI * settings.secondStrength) / 100;
    }
  }
}
