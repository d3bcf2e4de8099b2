import { SETTINGS, type Settings } from './settings.js';

/** The lines that make the look of the page in a project of one's own. */
export function codeSample(settings: Settings): string {
  const map = [`style: '${settings.mapStyle}'`];
  if (settings.mapSize !== SETTINGS.mapSize.default) map.push(`size: ${settings.mapSize}`);
  if (settings.mapTones !== SETTINGS.mapTones.default) map.push(`tones: ${settings.mapTones}`);
  map.push(`seed: ${settings.mapSeed}`);
  const rotation = { along: '0', towards: 'Math.PI / 2', angle: `(${settings.strokeAngle} / 180) * Math.PI` };
  const material = [
    'tonalArtMap',
    `technique: '${settings.technique}'`,
    `strokeScale: ${round(settings.strokeScale)}, // tiles per unit; this page scales models to a radius of 1`,
    `strokeRotation: ${rotation[settings.strokeDirection]}`,
    `toneModel: '${settings.toneModel}'`,
    `toneNormal: '${settings.toneNormal}'`,
    `ink: '${settings.ink}'`,
    `paper: '${settings.paper}'`,
    `color: '${settings.color}'`,
  ];
  const light = {
    directional: `new DirectionalLight('white', ${round((Math.PI * settings.lightStrength) / 100)})`,
    point: `new PointLight('white', ${round((Math.PI * settings.lightStrength) / 100)}, 0, 0)`,
    spot: `new SpotLight('white', ${round((Math.PI * settings.lightStrength) / 100)}, 0, ${round((settings.spotAngle * Math.PI) / 360)}, ${settings.spotSoftness / 100}, 0)`,
  }[settings.lightKind];
  return `import { ${/new (\w+)/.exec(light)![1]}, Mesh } from 'three';
import { HatchingMaterial, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';

const tonalArtMap = await TonalArtMap.generate({ ${map.join(', ')} });
const material = new HatchingMaterial({
${material.map((line) => `  ${line.includes('//') ? line : `${line},`}`).join('\n')}
});
scene.add(new Mesh(await prepareHatchingGeometry(geometry), material));

const light = ${light};
light.position.setFromSphericalCoords(${settings.lightKind === 'directional' ? 1 : round(settings.lightDistance)}, ${round(((90 - settings.lightElevation) * Math.PI) / 180)}, ${round((settings.lightAzimuth * Math.PI) / 180)});
scene.add(light);
`;
}

function round(value: number): number {
  return Math.round(value * 1000) / 1000;
}
