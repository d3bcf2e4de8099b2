import forms from 'virtual:form-sources';
import { baseName, extensionOf, withoutGz } from '../../viewer/files/common/fileName.js';
import { shownName } from '../../viewer/files/common/shownText.js';
import { type FormatLoader, formatOf } from '../../viewer/files/formats.js';
import { BUST_FOOT } from '../models/models.js';
import type { CodeModel } from './CodeModel.js';
import { CDN } from './versions.js';

/** How copied code gets its model. */
export interface ModelSource {
  /** Import declarations, except those from `three`. */
  imports: string[];
  /** The classes of three.js that it needs. */
  classes: string[];
  /** Functions that the statements call. */
  functions?: string;
  /** Statements, of which the last ones declare `model`, an Object3D; and `animations`, if `hasClips`. */
  code: string;
  hasClips?: boolean;
  /** Whether the model is one mesh, whose `geometry` is declared, too. */
  hasGeometry?: boolean;
  /** What users of the code have to know. */
  note?: string;
}

const GLTF = formatOf('glb')!.loader!;

const DRAGONS = {
  dragon4: 'dragon_vrip_res4',
  dragon3: 'dragon_vrip_res3',
  dragon2: 'dragon_vrip_res2',
  dragon1: 'dragon_vrip',
} as const;

/** The code that loads or makes the model that the page shows. */
export function modelSource(model: CodeModel): ModelSource {
  const source = sourceOf(model);
  if (!source.hasGeometry) return source;
  return {
    ...source,
    classes: [...source.classes, 'Mesh', 'MeshStandardMaterial'],
    code: `${source.code}\nconst model = new Mesh(geometry, new MeshStandardMaterial());`,
  };
}

/** As {@link modelSource}, but without the mesh of a geometry. */
function sourceOf({ model, title }: CodeModel): ModelSource {
  if (model === 'file') return fileSource(title);
  switch (model) {
    case 'dragon4':
    case 'dragon3':
    case 'dragon2':
    case 'dragon1':
      return gzippedSource(`${CDN.dragon}/models/${DRAGONS[model]}.ply.gz`, formatOf('ply')!.loader!);
    case 'bunny':
      return {
        imports: ["import * as bunny from 'bunny';"],
        classes: ['BufferGeometry', 'Float32BufferAttribute'],
        code: `const { positions, cells } = bunny.default ?? bunny;
const geometry = new BufferGeometry().setIndex(cells.flat());
geometry.setAttribute('position', new Float32BufferAttribute(positions.flat(), 3));`,
        hasGeometry: true,
      };
    case 'suzanne': {
      const source = loaderSource('suzanne', GLTF);
      return { ...source, imports: ["import suzanne from '@pmndrs/assets/models/suzi.glb.js';", ...source.imports] };
    }
    case 'teapot':
      return shapeSource('new TeapotGeometry(1, 12)', [
        "import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';",
      ]);
    case 'cube':
      return {
        imports: [],
        classes: ['BoxGeometry'],
        code: 'const geometry = new BoxGeometry(1, 1, 1);',
        hasGeometry: true,
      };
    case 'sphere':
      return shapeSource('new IcosahedronGeometry(1, 12)', [], ['IcosahedronGeometry']);
    case 'fish':
      return { ...sceneSource('makeFish', 'model, animations'), hasClips: true };
    case 'house':
      return sceneSource('makeHouse', 'model');
    case 'drapery':
      return sceneSource('makeDrapery', 'model');
    case 'stairs':
      return sceneSource('makeStairs', 'model');
    case 'room':
      return sceneSource('makeRoom', 'model');
    case 'street':
      return sceneSource('makeStreet', 'model');
    case 'fox':
      return sceneSource('makeFox', 'model');
    case 'bust':
      return {
        imports: [
          "import * as bust from 'snowden/lo.js';",
          "import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';",
        ],
        classes: ['BufferGeometry', 'Float32BufferAttribute'],
        code: `const { positions, cells } = bust.default ?? bust;
// Two stray triangles lie far below the bust.
const corners = cells.filter((cell) => cell.every((i) => positions[i][1] >= ${BUST_FOOT})).flat();
const shape = new BufferGeometry();
shape.setAttribute('position', new Float32BufferAttribute(corners.flatMap((i) => positions[i]), 3));
const geometry = mergeVertices(shape, 1e-6);`,
        hasGeometry: true,
      };
    case 'hand':
      return {
        imports: [importOf(GLTF)],
        classes: ['Group', 'MeshStandardMaterial'],
        code: `const { scene: hand } = await new GLTFLoader().loadAsync('${CDN.hand}/dist/profiles/generic-hand/right.glb');
hand.traverse((object) => {
  if (object.isMesh) object.material = new MeshStandardMaterial(); // not the grey of a glove
});
const model = new Group().add(hand);
model.quaternion.set(Math.SQRT1_2, 0, Math.SQRT1_2, 0); // its fingers up, its back to the viewer`,
      };
    default: {
      const { imports, classes, code: functions } = forms[model];
      return { ...shapeSource(`${model}()`, imports, classes), functions };
    }
  }
}

/** A scene that one of our functions makes. @param taken what is taken of it: `root` as `model`, and perhaps its clips */
function sceneSource(
  form: Extract<keyof typeof forms, `make${string}`>,
  taken: 'model' | 'model, animations',
): ModelSource {
  const { code: functions, ...source } = forms[form];
  return { ...source, functions, code: `const { root: ${taken} } = ${form}();` };
}

/** A shape of three.js with the vertices merged that are doubled for texture coordinates, as the page draws it. */
function shapeSource(made: string, imports: string[], classes: string[] = []): ModelSource {
  return {
    imports: [...imports, "import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';"],
    classes,
    code: `const shape = ${made};
shape.deleteAttribute('uv').deleteAttribute('normal');
const geometry = mergeVertices(shape, 1e-4);`,
    hasGeometry: true,
  };
}

function fileSource(title: string): ModelSource {
  const name = baseName(title);
  const isPacked = withoutGz(name) !== name;
  const extension = extensionOf(withoutGz(name)) ?? '';
  const note = `Put ${inComment(name)} beside this file. A web server must serve both: browsers load no models from file:// addresses.`;
  const format = formatOf(extension);
  const loader = format?.loader;
  if (format && !loader) {
    const saved = `three.js has no loader for ${format.name}: save ${inComment(name)} as GLB, and write its name below.`;
    return { ...loaderSource("'model.glb'", GLTF), note: saved };
  }
  if (!loader) {
    const unpacked = `The model came in ${inComment(name)}: unpack it, and write the name of the model below.`;
    return { ...loaderSource("'model.glb'", GLTF), note: unpacked };
  }
  if (isPacked) return { ...gzippedSource(name, loader), note };
  return { ...loaderSource(inQuotes(name), loader), note };
}

/** A name that cannot end the comment it is written into. */
const inComment = (name: string): string => shownName(name).replaceAll('*/', '* /');

/** Characters that would let code look different from what it does: they change the direction of text, or are invisible. */
const UNSEEN = /[\p{Cc}\p{Cf}\p{Default_Ignorable_Code_Point}\u2028\u2029]/gu;

const escapeCode = (character: string): string => `\\u{${character.codePointAt(0)!.toString(16)}}`;

/** A string as source code that may also stand in an HTML page. */
export function inQuotes(text: string): string {
  const escaped = JSON.stringify(text).slice(1, -1).replaceAll('\\"', '"').replaceAll("'", "\\'");
  return `'${escaped.replaceAll('<', '\\x3c').replace(UNSEEN, escapeCode)}'`;
}

const importOf = ({ name, module = name }: FormatLoader): string =>
  `import { ${name} } from 'three/addons/loaders/${module}.js';`;

/** Code that loads a file. @param address the address as source code */
function loaderSource(address: string, loader: FormatLoader): ModelSource {
  if (loader === GLTF) {
    return {
      imports: [
        "import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';",
        "import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';",
        importOf(loader),
      ],
      classes: [],
      code: `const loader = new GLTFLoader().setDRACOLoader(new DRACOLoader()).setMeshoptDecoder(MeshoptDecoder);
const { scene: model, animations } = await loader.loadAsync(${address});`,
      hasClips: true,
    };
  }
  return taken(loader, `await new ${loader.name}().loadAsync(${address})`);
}

/** A file that is unpacked before it is read. */
function gzippedSource(address: string, loader: FormatLoader): ModelSource {
  const { code, ...source } = taken(loader, `new ${loader.name}().parse(await new Response(unpacked).arrayBuffer())`);
  return {
    ...source,
    code: `const packed = await fetch(${inQuotes(address)});
const unpacked = packed.body.pipeThrough(new DecompressionStream('gzip'));
${code}`,
  };
}

/** Code that takes the model out of what a loader returns. */
function taken(loader: FormatLoader, given: string): ModelSource {
  const imports = [importOf(loader)];
  if (loader.gives === 'object') return { imports, classes: [], code: `const model = ${given};` };
  if (loader.gives === 'scene') return { imports, classes: [], code: `const { scene: model } = ${given};` };
  return { imports, classes: [], code: `const geometry = ${given};`, hasGeometry: true };
}
