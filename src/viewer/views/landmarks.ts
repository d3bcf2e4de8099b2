import type { MeshParts } from '../files/mesh/PlainMesh.js';

/** The middle of a part whose name says that it is in front, or behind. */
export interface Landmark {
  x: number;
  z: number;
  /** 1 in front, −1 behind. */
  sign: 1 | -1;
}

/** Words for what is in front and behind, in languages that names are often in. */
const FRONT =
  /^(front|vorne?|avant|eyes?|eyeballs?|iris|pupils?|cornea|augen?|yeux|ojos?|olhos?|nose|nase|nez|nariz|mouth|lips?|teeth|tongue|beak|snout|muzzle|face|headlights?|headlamps?|windshield|windscreen|bonnet|grille|nosecone)$/;
const BACK = /^(back|rear|hinten|arriere|tail|taillights?|taillamps?|exhaust|tailpipe|backrest|mudflap)$/;

/** The parts of a mesh that are named for the front or the back. @param positions xyz of each vertex, upright */
export function landmarksOf(positions: Float32Array, { names, ofVertices }: MeshParts): Landmark[] {
  const signs = names.map(signOf);
  if (signs.every((sign) => sign === 0)) return [];
  const sums = new Float64Array(3 * names.length);
  for (let vertex = 0; vertex < ofVertices.length; vertex++) {
    const part = ofVertices[vertex];
    if (signs[part] === 0) continue;
    sums[3 * part] += positions[3 * vertex];
    sums[3 * part + 1] += positions[3 * vertex + 2];
    sums[3 * part + 2]++;
  }
  return signs.flatMap((sign, part) => {
    const count = sums[3 * part + 2];
    return sign === 0 || count === 0 ? [] : [{ x: sums[3 * part] / count, z: sums[3 * part + 1] / count, sign }];
  });
}

/** 1 for a name of what is in front, −1 for one of what is behind, 0 for others and for names that say both. */
export function signOf(name: string): 1 | -1 | 0 {
  const words = name
    .replace(/(\p{Ll})(\p{Lu})/gu, '$1 $2')
    .normalize('NFD')
    .replace(/\p{M}/gu, '')
    .toLowerCase()
    .split(/[^a-z]+/);
  const isFront = words.some((word) => FRONT.test(word));
  const isBack = words.some((word) => BACK.test(word));
  return isFront === isBack ? 0 : isFront ? 1 : -1;
}
