import type { Mesh, MeshPhongMaterial, Object3D } from 'three';
import { ColladaLoader } from 'three/addons/loaders/ColladaLoader.js';
import { triangulatePolygon } from '../mesh/triangulatePolygon.js';
import { withFakeDocument, XmlElement, XmlParser } from './fakeDocument.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';

/** Reads a COLLADA file (DAE), with its clips. @throws Error of the loader */
export function readCollada(bytes: Uint8Array, name: string): LoadedScene {
  const text = new TextDecoder().decode(bytes);
  const root = withFakeDocument(() => new ColladaLoader().parse(text, '')?.scene, ColladaXml);
  if (root) takeMasks(root);
  return sceneOf(root, name);
}

/** Elements with polygons, strips or fans. */
const PRIMITIVES = ['polygons', 'polylist', 'tristrips', 'trifans'];

/**
 * Parses COLLADA for three's loader, with triangles only. Of several `polygons` the loader reads only the last and ignores holes, it splits
 * all quads along the same diagonal, and it skips strips and fans.
 */
class ColladaXml extends XmlParser {
  override parseFromString(text: string): ReturnType<XmlParser['parseFromString']> {
    const document = super.parseFromString(text);
    for (const mesh of document.getElementsByTagName('mesh')) {
      const points = pointsOf(mesh);
      for (const [i, child] of mesh.childNodes.entries())
        if (PRIMITIVES.includes(child.nodeName)) mesh.childNodes[i] = asTriangles(child, points);
    }
    for (const technique of document.getElementsByTagName('technique')) technique.childNodes.forEach(placeMask);
    return document;
  }
}

/** The map slots that are not drawn: the first receives an opacity map, the second a transparency map. */
const UNDRAWN = ['ambient', 'specular'];

/** Moves a transparency map, which three's loader drops, to an unused slot. A colour map already contains its alpha. */
function placeMask(shader: XmlElement): void {
  const childOf = (name: string): XmlElement | undefined => shader.childNodes.find((child) => child.nodeName === name);
  const [transparent, texture, colours] = [
    childOf('transparent'),
    childOf('transparent')?.querySelector('texture'),
    childOf('diffuse')?.querySelector('texture'),
  ];
  const own = shader.childNodes.filter(({ nodeName }) => !UNDRAWN.includes(nodeName));
  if (own.length < shader.childNodes.length) shader.childNodes.splice(0, Infinity, ...own);
  if (!transparent || !texture) return;
  const opaque = transparent.getAttribute('opaque') ?? 'A_ONE';
  if (opaque === 'A_ONE' && colours?.getAttribute('texture') === texture.getAttribute('texture')) return;
  const mask = new XmlElement(UNDRAWN[opaque.endsWith('ZERO') ? 1 : 0]);
  mask.childNodes.push(texture);
  shader.childNodes.push(mask);
}

/** Turns the transparency maps that {@link ColladaXml} has moved into alpha maps of their materials. */
function takeMasks(root: Object3D): void {
  root.traverse((object) => {
    for (const material of [(object as Partial<Mesh>).material ?? []].flat() as MeshPhongMaterial[]) {
      const { lightMap, specularMap } = material;
      material.alphaMap ??= lightMap ?? specularMap ?? null;
      if (specularMap) specularMap.userData.isInverted = true;
      Object.assign(material, { lightMap: null, specularMap: null });
    }
  });
}

/** The coordinates of a mesh, and the number of inputs per corner. */
interface Points {
  values: number[];
  stride: number;
}

function pointsOf(mesh: XmlElement): Points {
  const inputs = mesh.getElementsByTagName('vertices').flatMap((vertices) => vertices.getElementsByTagName('input'));
  const id = inputs
    .find((input) => input.getAttribute('semantic') === 'POSITION')
    ?.getAttribute('source')
    ?.slice(1);
  const source = mesh.childNodes.find((child) => child.nodeName === 'source' && child.getAttribute('id') === id);
  const stride = Number(source?.querySelector('accessor')?.getAttribute('stride') ?? 3);
  return { values: numbersIn(source?.querySelector('float_array')), stride: stride >= 3 ? stride : 3 };
}

const numbersIn = (element: XmlElement | null | undefined): number[] =>
  element ? (element.textContent.match(/\S+/g) ?? []).map(Number) : [];

/** Converts an element to triangles with the same corners. */
function asTriangles(element: XmlElement, points: Points): XmlElement {
  const inputs = element.childNodes.filter(({ nodeName }) => nodeName === 'input');
  const offsetOf = (input: XmlElement | undefined): number => Number(input?.getAttribute('offset') ?? 0);
  const vertex = offsetOf(inputs.find((input) => input.getAttribute('semantic') === 'VERTEX'));
  const stride = 1 + Math.max(0, ...inputs.map(offsetOf));
  const corners: number[] = [];
  for (const rings of polygonsOf(element, stride)) {
    const polygon = rings.flat();
    const holes = rings.slice(1).map((_, i) => rings.slice(0, i + 1).reduce((sum, { length }) => sum + length, 0));
    const places = polygon.flatMap((corner) =>
      [0, 1, 2].map((axis) => points.values[points.stride * corner[vertex] + axis] ?? NaN),
    );
    for (const corner of triangulatePolygon(places, holes)) for (const number of polygon[corner]) corners.push(number);
  }
  const triangles = new XmlElement('triangles');
  triangles.attributes.push(...element.attributes);
  triangles.setAttribute('count', String(corners.length / stride / 3));
  const written = new XmlElement('p');
  written.addText(corners.join(' '));
  triangles.childNodes.push(...inputs, written);
  return triangles;
}

/** Indices of a corner: its vertex, then its other inputs. */
type Corner = number[];

/** The outline of each polygon, followed by its holes. */
function polygonsOf(element: XmlElement, stride: number): Corner[][][] {
  const named = (name: string): XmlElement[] => element.childNodes.filter(({ nodeName }) => nodeName === name);
  const lists = named('p').map((p) => cornersIn(p, stride));
  const inRow = (list: readonly Corner[], triangle: (i: number) => number[]): Corner[][][] =>
    list.slice(2).map((_, i) => [triangle(i).map((corner) => list[corner])]);
  switch (element.nodeName) {
    case 'tristrips':
      return lists.flatMap((list) => inRow(list, (i) => (i % 2 === 0 ? [i, i + 1, i + 2] : [i + 1, i, i + 2])));
    case 'trifans':
      return lists.flatMap((list) => inRow(list, (i) => [0, i + 1, i + 2]));
    case 'polylist': {
      const [list = []] = lists;
      let start = 0;
      return numbersIn(named('vcount')[0]).map((count) => {
        start += count;
        return [list.slice(start - count, start)];
      });
    }
    default: {
      const holed = named('ph').map((ph) =>
        ph.childNodes
          .filter(({ nodeName }) => nodeName === 'p' || nodeName === 'h')
          .map((ring) => cornersIn(ring, stride)),
      );
      return [...lists.map((list) => [list]), ...holed];
    }
  }
}

function cornersIn(element: XmlElement, stride: number): Corner[] {
  const numbers = numbersIn(element);
  return Array.from({ length: Math.floor(numbers.length / stride) }, (_, i) =>
    numbers.slice(stride * i, stride * (i + 1)),
  );
}
