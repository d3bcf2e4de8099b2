import type { Settings } from '../settings/settings.js';
import { SECOND_LIGHT_AZIMUTH } from '../settings/settingValues.js';
import { round } from './round.js';

/** Code that adds the lights of the page to `scene`, and the classes of three.js that it needs. */
export function lightSample(settings: Settings): { code: string; classes: string[] } {
  const intensity = round((Math.PI * settings.lightStrength) / 100);
  const light = {
    directional: `new DirectionalLight('white', ${intensity})`,
    point: `new PointLight('white', ${intensity}, 0, 0)`,
    spot: `new SpotLight('white', ${intensity}, 0, ${round((settings.spotAngle * Math.PI) / 360)}, ${settings.spotSoftness / 100}, 0)`,
  }[settings.lightKind];
  const place = (distance: number, azimuth: number) =>
    `setFromSphericalCoords(${distance}, ${round(((90 - settings.lightElevation) * Math.PI) / 180)}, ${round((azimuth * Math.PI) / 180)})`;
  const distance = settings.lightKind === 'directional' ? 1 : round(settings.lightDistance);
  const stay = (name: string) =>
    settings.lightFollows === 'viewer'
      ? `${name}.position.applyQuaternion(camera.quaternion); // again in every frame, to stay with the viewer\n`
      : '';
  const parts = [
    `const light = ${light};
light.position.${place(distance, settings.lightAzimuth)};
${stay('light')}scene.add(light);
`,
  ];
  const classes = [/new (\w+)/.exec(light)![1]];
  if (settings.shadows === 'on') {
    const turning =
      settings.shadowStrokes === 'tone'
        ? ''
        : `
  if (object.material.isHatchingMaterial) object.material.shadowStrokes = '${settings.shadowStrokes}';`;
    parts.push(`
renderer.shadowMap.enabled = true;
light.castShadow = true; // fit light.shadow.camera and light.shadow.normalBias to the size of your scene
scene.traverse((object) => {
  if (!object.isMesh) return;
  object.castShadow = object.receiveShadow = true;${turning}
});
`);
  }
  if (settings.secondLight !== 'none') {
    classes.push('DirectionalLight');
    const azimuth = settings.lightAzimuth + SECOND_LIGHT_AZIMUTH[settings.secondLight];
    parts.push(`
const second = new DirectionalLight('white', ${round((Math.PI * settings.secondStrength) / 100)});
second.position.${place(1, azimuth)};
${stay('second')}scene.add(second);
`);
  }
  return { code: parts.join(''), classes };
}
