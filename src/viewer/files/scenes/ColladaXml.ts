import type { Mesh, MeshPhongMaterial, Object3D } from 'three';
import { triangulatePolygon } from '../mesh/triangulatePolygon.js';
import { XmlElement, XmlParser } from './XmlElement.js';

/** Elements with polygons, strips or fans. */
const PRIMITIVES = ['polygons', 'polylist', 'tristrips', 'trifans'];

/**
 * Parses COLLADA for three's loader, with triangles alone: of `polygons` the loader reads the last one and no holes, it cuts all of four corners
 * along one line, whatever their shape, and leaves out strips and fans.
 */
export class ColladaXml extends XmlParser {
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

/** The places of pictures that are not drawn. In the first goes one of opacity, in the second one of transparency. */
const UNDRAWN = ['ambient', 'specular'];

/**
 * Puts the picture of a surface's transparency in the place of another that is not drawn, since three's loader leaves it out. That of its colours
 * has its alpha already.
 */
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

/** Makes the pictures of transparency that {@link ColladaXml} has placed the alpha of their materials. */
export function takeMasks(root: Object3D): void {
  root.traverse((object) => {
    for (const material of [(object as Partial<Mesh>).material ?? []].flat() as MeshPhongMaterial[]) {
      const { lightMap, specularMap } = material;
      material.alphaMap ??= lightMap ?? specularMap ?? null;
      if (specularMap) specularMap.userData.isInverted = true;
      Object.assign(material, { lightMap: null, specularMap: null });
    }
  });
}

/** The coordinates of a mesh, and how many numbers each point takes. */
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

/** The element of triangles with the same corners. */
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

/** A corner: the numbers of its vertex and of what else it has. */
type Corner = number[];

/** The outline of each polygon, and its holes. */
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
