import { ClampToEdgeWrapping, type Mesh, type MeshPhongMaterial, type Object3D } from 'three';
import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { baseName } from '../common/fileName.js';
import type { FindFile } from '../common/Surroundings.js';
import { toUtf8 } from '../common/toUtf8.js';
import type { LoadedScene } from '../scenes/LoadedScene.js';
import { withoutDocument } from '../scenes/withoutDocument.js';
import { clampedMaterials, cleanMtl, cleanObj, materialLibraries, namesIn, otherThanFaces } from './cleanObj.js';
import { writeFaces } from './writeFaces.js';

/** Reads an OBJ file, with the materials of its MTL files if they were dropped along. */
export async function readObj(bytes: Uint8Array, findFile: FindFile): Promise<LoadedScene> {
  const decoder = new TextDecoder();
  const text = decoder.decode(bytes);
  const { materials, missing } = await findMaterials(materialLibraries(text), findFile);
  const loader = new OBJLoader();
  const root = withoutDocument(() => {
    if (materials) loader.setMaterials(new MTLLoader().parse(cleanMtl(materials), ''));
    return loader.parse(writeFaces(cleanObj(text)));
  });
  clamp(root, clampedMaterials(materials));
  return { root, missing, notes: otherThanFaces(text, materials) };
}

/** Clamps the pictures of some materials. */
function clamp(root: Object3D, names: ReadonlySet<string>): void {
  if (names.size === 0) return;
  root.traverse((object) => {
    for (const material of [(object as Partial<Mesh>).material ?? []].flat() as MeshPhongMaterial[]) {
      if (material.map && names.has(material.name)) material.map.wrapS = material.map.wrapT = ClampToEdgeWrapping;
    }
  });
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
