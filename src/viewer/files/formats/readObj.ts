import { ClampToEdgeWrapping, type Mesh, type MeshPhongMaterial, type Object3D } from 'three';
import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { toUtf8 } from '../common/AsciiReader.js';
import { baseName } from '../common/ModelFile.js';
import type { FindFile } from '../common/Surroundings.js';
import { withFakeDocument } from '../scenes/fakeDocument.js';
import { DISPLACEMENT_NOTE, type LoadedScene } from '../scenes/LoadedScene.js';
import type { NamedRun } from '../scenes/mergeScene.js';
import { writeFaces } from './writeFaces.js';

/** Reads an OBJ file, with the materials of its MTL files if they were dropped along. */
export async function readObj(bytes: Uint8Array, findFile: FindFile): Promise<LoadedScene> {
  const decoder = new TextDecoder();
  const text = decoder.decode(bytes);
  const { materials, missing } = await findMaterials(materialLibraries(text), findFile);
  const loader = new OBJLoader();
  const written = writeFaces(cleanObj(text));
  const root = withFakeDocument(() => {
    if (materials) loader.setMaterials(new MTLLoader().parse(cleanMtl(materials), ''));
    return loader.parse(written);
  });
  nameRuns(root, written);
  const made = materialsOf(root);
  clamp(made, clampedMaterials(materials));
  letPicturesCut(made);
  return { root, missing, notes: otherThanFaces(text, materials) };
}

function materialsOf(root: Object3D): Set<MeshPhongMaterial> {
  const found = new Set<MeshPhongMaterial>();
  root.traverse((object) => {
    for (const material of [(object as Partial<Mesh>).material ?? []].flat()) found.add(material as MeshPhongMaterial);
  });
  return found;
}

/** Clamps the pictures of some materials. */
function clamp(materials: Iterable<MeshPhongMaterial>, names: ReadonlySet<string>): void {
  for (const { map, name } of materials) if (map && names.has(name)) map.wrapS = map.wrapT = ClampToEdgeWrapping;
}

/** Lets colour maps cut out surfaces by their alpha: many programs name no alpha map for leaves and grilles. */
function letPicturesCut(materials: Iterable<MeshPhongMaterial>): void {
  for (const material of materials) {
    const { map, alphaMap, opacity, userData } = material;
    if (!map || alphaMap || opacity < 1) continue;
    material.alphaTest = 0.5;
    userData.mayBeWhole = true;
  }
}

/** The concatenated text of all material files, and the names of those that are missing. */
async function findMaterials(
  libraries: readonly string[],
  findFile: FindFile,
): Promise<{ materials: string; missing: string[] }> {
  const texts: string[] = [];
  const missing: string[] = [];
  const read = async (library: string): Promise<boolean> => {
    const found = await findFile(library);
    if (found) texts.push(new TextDecoder().decode(toUtf8(found)));
    return found !== undefined;
  };
  /** The missing names in a text with spaces: one name, unless a file named by one of its words was dropped. */
  const missingOf = async (name: string): Promise<string[]> => {
    const words = name.split(/\s+/);
    const absent: string[] = [];
    for (const word of words) if (!(await read(word))) absent.push(word);
    return (absent.length < words.length ? absent : [name]).map(baseName);
  };
  for (const line of new Set(libraries)) {
    if (await read(line)) continue;
    for (const name of namesIn(line)) if (!(await read(name))) missing.push(...(await missingOf(name)));
  }
  return { materials: texts.join('\n'), missing };
}

/**
 * Reduces an OBJ file to the lines of triangles that three's loader reads correctly: vertices, faces, smoothing groups and materials. Names
 * of objects and groups become comments, see {@link nameRuns}.
 * Otherwise the loader takes words of comments for corners and faces next to lines or points for lines, and takes minutes for many groups.
 */
function cleanObj(text: string): string {
  return withAllColors(
    withLineFeeds(text)
      .replace(/\\[ \t]*\n/g, ' ')
      // Names of materials may contain "#".
      .replace(/^([ \t]*(?:v[tn]?|f)[ \t][^#\n]*)#.*$/gm, '$1')
      .replace(/^[ \t]*usemtl[ \t]+/gm, 'usemtl ')
      // Lines without numbers count too; without them, faces would get the wrong vertices.
      .replace(/^[ \t]*v[ \t]*$/gm, 'v nan nan nan')
      .replace(/^[ \t]*(v[tn])[ \t]*$/gm, '$1 0 0 0')
      .replace(/^[ \t]*#.*$/gm, '')
      .replace(/^[ \t]*([og])(?:[ \t]+(.*?))?[ \t]*$/gm, '#$1 $2')
      .replace(/^(?![ \t]*(?:v[tn]?|f|s)[ \t]|usemtl |#[og] ).+$/gm, ''),
  );
}

/** Names of groups that say nothing. */
const NO_GROUP = /^(default|off|\(null\)|null)?$/i;

/**
 * Gives the only mesh of an OBJ file its named runs of triangles, by the comments that `cleanObj` has made of the names of its objects and
 * groups. Objects may have the same name; a group may be taken up again. Does nothing if there is only one.
 */
function nameRuns(root: Object3D, text: string): void {
  const [mesh, ...others] = root.getObjectsByProperty('isMesh', true);
  if (!mesh || others.length > 0 || !text.includes('#')) return;
  const parts = new Map<string, number>();
  const partOf = (key: string): number => {
    const part = parts.get(key) ?? parts.size;
    parts.set(key, part);
    return part;
  };
  const runs: NamedRun[] = [{ start: 0, name: '', part: partOf('') }];
  let [object, group, objects, corners] = ['', '', 0, 0];
  for (const [line, word, name = ''] of text.matchAll(/^(?:#([og])(?:[ \t](.*))?|[ \t]*f[ \t].*)$/gm)) {
    if (word === undefined) {
      corners += 3 * Math.max(0, line.trim().split(/[ \t]+/).length - 3);
      continue;
    }
    if (word === 'o') {
      [object, group] = [name, ''];
      objects++;
    } else group = NO_GROUP.test(name) ? '' : name;
    const whole = object && group && !group.startsWith(object) ? `${object}: ${group}` : group || object;
    const part = partOf(objects === 0 ? group : `${objects} ${group}`);
    const last = runs[runs.length - 1];
    if (last.start === corners) Object.assign(last, { name: whole, part });
    else if (last.part !== part) runs.push({ start: corners, name: whole, part });
  }
  if (new Set(runs.map(({ part }) => part)).size > 1) mesh.userData.runs = runs;
}

/** Makes vertices without a colour white where others have one. Otherwise three's loader assigns colours to the wrong vertices. */
function withAllColors(text: string): string {
  if (!/^[ \t]*v(?:[ \t]+\S+){6}/m.test(text)) return text;
  return withFractions(text).replace(/^([ \t]*v(?:[ \t]+\S+){3})(?:[ \t]+\S+){0,2}[ \t]*$/gm, '$1 1 1 1');
}

/** Divides integer colours by 255. */
function withFractions(text: string): string {
  const colored = /^([ \t]*v(?:[ \t]+\S+){3})[ \t]+(\S+)[ \t]+(\S+)[ \t]+(\S+)/gm;
  let largest = 0;
  for (const [, , ...rgb] of text.matchAll(colored)) {
    if (!rgb.every((value) => /^\d+(?:\.0*)?$/.test(value))) return text;
    largest = Math.max(largest, ...rgb.map(Number));
  }
  if (largest <= 1) return text;
  return text.replace(colored, (_, point: string, ...rgb: string[]) => {
    const shares = rgb.slice(0, 3).map((value) => Number(value) / 255);
    return `${point} ${shares.join(' ')}`;
  });
}

/** The names of material files in an OBJ file, line by line. A line may contain several, see {@link namesIn}. */
function materialLibraries(text: string): string[] {
  return [...withLineFeeds(text).matchAll(/^[ \t]*mtllib[ \t]+(.+?)[ \t]*$/gm)].map(([, names]) => names ?? '');
}

/** Splits the names of a line. They may contain spaces, and end with their extension. */
function namesIn(line: string): string[] {
  return line.match(/\S.*?\.mtl(?=\s|$)|\S.*/gi) ?? [];
}

/** Reduces an MTL file to what hatched surfaces show: colours, gloss, colour maps, opacity and cut-outs. */
function cleanMtl(text: string): string {
  return (
    withDissolve(withLineFeeds(text).replace(/^[ \t]*(newmtl|Kd|Ks|Ns|map_Kd|map_d|d|Tr)[ \t]+/gim, '$1 '))
      .replace(/^(?!(?:newmtl|Kd|Ks|Ns|map_Kd|map_d|d) ).+$/gim, '')
      // A single number is a grey; a spectrum is not supported.
      .replace(/^(K[ds]) ([-+.\de]+)[ \t]*$/gim, '$1 $2 $2 $2')
      .replace(/^K[ds] (?:spectral|xyz).*$/gim, '')
      .replace(/^(map_\w+) (.*)$/gim, (_, word: string, rest: string) => `${word} ${plainMap(rest)}`)
  );
}

/** The names of materials whose pictures are clamped. */
function clampedMaterials(text: string): Set<string> {
  const clamped = new Set<string>();
  let name = '';
  for (const line of withLineFeeds(text).split('\n')) {
    const [, material] = /^[ \t]*newmtl[ \t]+(.*?)[ \t]*$/i.exec(line) ?? [];
    if (material !== undefined) name = material;
    else if (/^[ \t]*map_Kd[ \t].*-clamp[ \t]+on\b/i.test(line)) clamped.add(name);
  }
  return clamped;
}

const NUMBERS = '(?:[ \\t]+[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:e[-+]?\\d+)?)';
/** An option of a map, with up to three numbers or a word, before or after the file name. */
const OPTION = `-(?:(s|o|t)(${NUMBERS}{1,3})|mm${NUMBERS}{2}|(?:blendu|blendv|boost|bm|cc|clamp|colorspace|imfchan|texres|type)[ \\t]+\\S+)`;
const OPTION_BEFORE = new RegExp(`^${OPTION}[ \\t]+`, 'i');
const OPTION_AFTER = new RegExp(`[ \\t]+${OPTION}$`, 'i');

/**
 * Rewrites a map's options for three's loader: scale and offset with three numbers each, then the file name. The loader takes other options
 * for a part of the name, and a part of the name for missing numbers.
 */
function plainMap(text: string): string {
  const found = { s: [1, 1, 1], o: [0, 0, 0] };
  let name = text.trim();
  for (const pattern of [OPTION_BEFORE, OPTION_AFTER]) {
    for (let option = pattern.exec(name); option; option = pattern.exec(name)) {
      name = name.replace(option[0], '');
      const values = found[option[1]?.toLowerCase() as keyof typeof found];
      option[2]
        ?.trim()
        .split(/[ \t]+/)
        .forEach((number, i) => {
          if (values) values[i] = Number(number);
        });
    }
  }
  name = name.replace(/^"(.*)"$/, '$1');
  const isPlain = found.s.every((value) => value === 1) && found.o.every((value) => value === 0);
  return isPlain ? name : `-s ${found.s.join(' ')} -o ${found.o.join(' ')} ${name}`;
}

/** Notes on the parts of an OBJ file and its materials that are not drawn, such as lines, points and curves. */
function otherThanFaces(text: string, materials: string): string[] {
  const notes: string[] = [];
  if (/^[ \t]*(?:map_)?disp[ \t]+\S/im.test(withLineFeeds(materials))) notes.push(DISPLACEMENT_NOTE);
  if (/^[ \t]*(?:[lp]|curv2?)[ \t]+[-\d]/m.test(text)) notes.push('points and lines left out');
  if (/^[ \t]*surf[ \t]/m.test(text)) notes.push('curved surfaces left out');
  return notes;
}

/**
 * Writes the opacity of each material as `d`, at the end of its lines. Some programs write `Tr`, which is the opposite, some write both and
 * mean `d`, and some write an option before it.
 */
const withDissolve = (text: string): string =>
  text
    .split(/^(?=newmtl )/im)
    .map((lines) => {
      const [, dissolve] = /^d (?:-halo[ \t]+)?([-+.\de]+)/im.exec(lines) ?? [];
      const [, transparency] = /^Tr ([-+.\de]+)/im.exec(lines) ?? [];
      const opacity = dissolve === undefined ? 1 - Number(transparency) : Number(dissolve);
      const rest = lines.replace(/^(?:d|Tr) .*$/gim, '');
      return Number.isFinite(opacity) ? `${rest}\nd ${Math.min(Math.max(opacity, 0), 1)}\n` : rest;
    })
    .join('');

const withLineFeeds = (text: string): string => (text.includes('\r') ? text.replace(/\r\n?/g, '\n') : text);
