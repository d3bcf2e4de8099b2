import type { PresetName } from 'three-hatching';
import type { Settings } from '../../viewer/settings/settings.js';
import { lightSample } from './lightSample.js';
import { compositionParameters } from './lookSample.js';
import { inQuotes } from './modelSource.js';

/**
 * Code that uses a preset by its name, without its settings.
 *
 * @param sceneRadius the radius of a loaded scene, which keeps its own colours; undefined if it is for one geometry
 * @param name the name of the file that the scene is loaded from
 */
export function presetSample(
  preset: PresetName,
  settings: Settings,
  sceneRadius: number | undefined,
  name: string,
): string {
  const isScene = sceneRadius !== undefined;
  const { code: lights, classes } = lightSample(settings, sceneRadius);
  const [load, model, tilesPerUnit] = isScene
    ? [
        `const { scene: model } = await new GLTFLoader().loadAsync(${inQuotes(name)});
scene.add(model);`,
        'model',
        `${Number((settings.tilesPerUnit / sceneRadius).toPrecision(3))}, // tiles per unit of the world`,
      ]
    : [
        `const mesh = new Mesh(geometry);
scene.add(mesh);`,
        'mesh',
        `${settings.tilesPerUnit}, // tiles per unit; this page scales models to a radius of 1`,
      ];
  if (!isScene) classes.push('Mesh');
  const isPaper = isScene && settings.surfaceColors === 'paper';
  const own = [
    ...(isPaper ? [`color: 'white'`, 'map: null', 'vertexColors: false'] : []),
    ...compositionParameters(settings),
  ];
  const material = own.length > 0 ? `\n  material: { ...presets.${preset}.material, ${own.join(', ')} },` : '';
  return `import { ${[...new Set(classes)].sort().join(', ')} } from 'three';
${isScene ? "import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';\n" : ''}import { applyHatching, presets } from 'three-hatching';

${load}
await applyHatching(${model}, {
  ...presets.${preset},
  tilesPerWorldUnit: ${tilesPerUnit}${material}
});

${lights}`;
}
