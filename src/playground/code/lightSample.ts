import type { Settings } from '../../viewer/settings/settings.js';
import { type LightPlace, placeOfLight, placeOfSecondLight } from '../../viewer/settings/settingValues.js';
import { intensityOf, mainLight, positionOf } from './lightSource.js';

/**
 * Code that adds the lights of the page to `scene`, and the classes of three.js that it needs.
 *
 * @param radius the radius of the scene that they light; the page's models have 1
 */
export function lightSample(settings: Settings, radius = 1): { code: string; classes: string[] } {
  const { made, name } = mainLight(settings);
  const at = (place: LightPlace) => positionOf(place, (place.distance ?? 1) * radius);
  const stay = (name: string) =>
    settings.lightFollows === 'viewer'
      ? `${name}.position.applyQuaternion(camera.quaternion); // again in every frame, to stay with the viewer\n`
      : '';
  const parts = [
    `const light = ${made};
light.position.${at(placeOfLight(settings))};
${stay('light')}scene.add(light);
`,
  ];
  const classes = [name];
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
  const second = placeOfSecondLight(settings);
  if (second) {
    classes.push('DirectionalLight');
    parts.push(`
const second = new DirectionalLight('white', ${intensityOf(settings.secondStrength)});
second.position.${at(second)};
${stay('second')}scene.add(second);
`);
  }
  return { code: parts.join(''), classes };
}
