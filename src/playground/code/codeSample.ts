import { presetOf } from '../../viewer/settings/presets.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { withBoldnessAndDensity } from '../../viewer/settings/withBoldnessAndDensity.js';
import { lightSample } from './lightSample.js';
import {
  compositionParameters,
  drawnWithMap,
  mapSource,
  materialParameters,
  outlineParameters,
  prepareArgument,
  shiftsStrokes,
} from './lookSample.js';
import { inQuotes } from './modelSource.js';
import { presetSample } from './presetSample.js';

/**
 * Code that gives the look of the page to a model in the user's own project.
 *
 * @param sceneRadius the radius of the scene, if the code is for a loaded scene, which keeps its own colours; undefined
 *   if it is for one geometry
 * @param name the name of the file that the scene is loaded from
 */
export function codeSample(settings: Settings, sceneRadius: number | undefined, name = 'model.glb'): string {
  const preset = presetOf(settings);
  return preset
    ? presetSample(preset, settings, sceneRadius, name)
    : wholeSample(withBoldnessAndDensity(settings), sceneRadius, name);
}

/** Code with every setting that has an effect. */
function wholeSample(settings: Settings, sceneRadius: number | undefined, name: string): string {
  const isScene = sceneRadius !== undefined;
  const material = [...materialParameters(settings, isScene), ...compositionParameters(settings)];
  const lights = lightSample(settings, sceneRadius);
  const classes = new Set(lights.classes);
  if (shiftsStrokes(settings)) classes.add('Vector2');
  if (!isScene) classes.add('Mesh');
  const parameters = material.map((line) => (line.includes('//') ? line : `${line},`));
  const outlines = settings.outlines === 'on' ? outlineParameters(settings) : undefined;
  const [names, use] = isScene
    ? [
        ['applyHatching'],
        `const { scene: model } = await new GLTFLoader().loadAsync(${inQuotes(name)});
scene.add(model);
await applyHatching(model, {
  tilesPerWorldUnit: ${Number((settings.tilesPerUnit / sceneRadius).toPrecision(3))}, // tiles per unit of the world
  material: {
${parameters.map((line) => `    ${line}`).join('\n')}
  },${outlines ? `\n  outlines: {\n${outlines.map((line) => `    ${line},`).join('\n')}\n  },` : ''}
});`,
      ]
    : [
        [...(outlines ? ['HatchingOutlines'] : []), 'HatchingMaterial', 'prepareHatchingGeometry'],
        `const material = new HatchingMaterial({
${parameters.map((line) => `  ${line}`).join('\n')}
});
${
  outlines
    ? `const mesh = new Mesh(await prepareHatchingGeometry(geometry${prepareArgument(settings, true)}), material);
mesh.add(
  new HatchingOutlines(mesh, {
${outlines.map((line) => `    ${line},`).join('\n')}
  }),
);
scene.add(mesh);`
    : `scene.add(new Mesh(await prepareHatchingGeometry(geometry${prepareArgument(settings)}), material));`
}`,
      ];
  const map = drawnWithMap(settings) ? `const tonalArtMap = ${mapSource(settings)};\n` : '';
  if (map) names.push('TonalArtMap');
  return `import { ${[...classes].sort().join(', ')} } from 'three';
${isScene ? "import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';\n" : ''}import { ${names.join(', ')} } from 'three-hatching';

${map}${use}

${lights.code}`;
}
