import { TEXELS_PER_STROKE } from './applyToMaterial.js';
import { isCrisp, SETTINGS, type Settings } from './settings.js';

/**
 * The lines that make the look of the page in a project of one's own.
 *
 * @param isScene whether it is the look of a loaded scene, in its own colours, instead of one geometry's
 */
export function codeSample(settings: Settings, isScene: boolean): string {
  const map = [`style: '${settings.mapStyle}'`];
  if (settings.mapSize !== SETTINGS.mapSize.default) map.push(`size: ${settings.mapSize}`);
  if (settings.mapTones !== SETTINGS.mapTones.default) map.push(`tones: ${settings.mapTones}`);
  map.push(`seed: ${settings.mapSeed}`);
  const rotation = { along: '0', towards: 'Math.PI / 2', angle: `(${settings.strokeAngle} / 180) * Math.PI` };
  const { technique } = settings;
  const material = ['tonalArtMap', `technique: '${technique === 'adjacencyCrisp' ? 'adjacency' : technique}'`];
  if (technique === 'adjacencyCrisp') material.push('crisp: true');
  if (technique === 'anchored') {
    material.push(`screenConstancy: ${settings.screenConstancy / 100}`, `anchorSpacing: ${settings.anchorSpacing}`);
  }
  if (isCrisp(technique)) {
    material.push(
      `texelPixels: ${round(settings.strokeWidth / TEXELS_PER_STROKE)} * renderer.getPixelRatio()`,
      `edgePixels: ${settings.edge}`,
    );
  }
  if (settings.toneNormal !== 'auto') material.push(`toneNormal: '${settings.toneNormal}'`);
  if (!isScene) {
    material.push(
      `strokeScale: ${round(settings.strokeScale)}, // tiles per unit; this page scales models to a radius of 1`,
    );
  }
  material.push(
    `strokeRotation: ${rotation[settings.strokeDirection]}`,
    `toneModel: '${settings.toneModel}'`,
    `ink: '${settings.ink}'`,
    `paper: '${settings.paper}'`,
  );
  if (!isScene) material.push(`color: '${settings.color}'`);
  const light = {
    directional: `new DirectionalLight('white', ${round((Math.PI * settings.lightStrength) / 100)})`,
    point: `new PointLight('white', ${round((Math.PI * settings.lightStrength) / 100)}, 0, 0)`,
    spot: `new SpotLight('white', ${round((Math.PI * settings.lightStrength) / 100)}, 0, ${round((settings.spotAngle * Math.PI) / 360)}, ${settings.spotSoftness / 100}, 0)`,
  }[settings.lightKind];
  const isReflected = settings.reflectedLight > 0;
  const reflected = `
// What the surroundings reflect: from behind, nothing on the lit side.
const reflected = new HemisphereLight('white', 'black', ${round((Math.PI * settings.reflectedLight) / 100)});
reflected.position.copy(light.position).negate();
scene.add(reflected);
`;
  const parameters = material.map((line) => (line.includes('//') ? line : `${line},`));
  const [imports, use] = isScene
    ? [
        'applyHatching, TonalArtMap',
        `const { scene: model } = await new GLTFLoader().loadAsync(address); // from 'three/addons/loaders/GLTFLoader.js'
scene.add(model);
await applyHatching(model, {
  strokeScale: ${round(settings.strokeScale)} / radius, // tiles per unit of the world; radius of the model
  material: {
${parameters.map((line) => `    ${line}`).join('\n')}
  },
});`,
      ]
    : [
        'HatchingMaterial, prepareHatchingGeometry, TonalArtMap',
        `const material = new HatchingMaterial({
${parameters.map((line) => `  ${line}`).join('\n')}
});
scene.add(new Mesh(await prepareHatchingGeometry(geometry), material));`,
      ];
  return `import { ${/new (\w+)/.exec(light)![1]}${isReflected ? ', HemisphereLight' : ''}${isScene ? '' : ', Mesh'} } from 'three';
import { ${imports} } from 'three-hatching';

const tonalArtMap = await TonalArtMap.generate({ ${map.join(', ')} });
${use}

const light = ${light};
light.position.setFromSphericalCoords(${settings.lightKind === 'directional' ? 1 : round(settings.lightDistance)}, ${round(((90 - settings.lightElevation) * Math.PI) / 180)}, ${round((settings.lightAzimuth * Math.PI) / 180)});
scene.add(light);
${isReflected ? reflected : ''}`;
}

function round(value: number): number {
  return Math.round(value * 1000) / 1000;
}
