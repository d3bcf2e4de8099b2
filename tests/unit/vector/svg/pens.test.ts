import DxfParser from 'dxf-parser';
import { BoxGeometry, BufferAttribute, Color, type Mesh, SphereGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import type { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import type { DrawSVGOptions } from '../../../../src/vector/svg/DrawSVGOptions.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';

/** A coloured ball on its own place, with names for the mesh and its material. */
async function ball(name: string, x: number, color: string, ink = 'black'): Promise<Mesh> {
  const look = { material: { ink }, outlines: { ink } };
  const mesh = await hatchedMesh(new SphereGeometry(0.3, 24, 16).translate(x, 0, 0), look);
  const material = mesh.material as HatchingMaterial;
  material.color.set(color);
  material.name = `${name} paint`;
  mesh.name = name;
  return mesh;
}

/** A box whose left half is red and whose right half is blue, by the colours of its vertices. */
async function twoColoured(): Promise<Mesh> {
  const geometry = new BoxGeometry(1, 1, 1, 2, 1, 1).toNonIndexed();
  const { position } = geometry.attributes;
  const [red, blue] = [new Color('red'), new Color('blue')];
  const colors = new Float32Array(3 * position.count);
  for (let corner = 0; corner < position.count; corner += 3) {
    const isLeft = position.getX(corner) + position.getX(corner + 1) + position.getX(corner + 2) < 0;
    for (let k = 0; k < 3; k++) (isLeft ? red : blue).toArray(colors, 3 * (corner + k));
  }
  geometry.setAttribute('color', new BufferAttribute(colors, 3));
  const mesh = await hatchedMesh(geometry, { outlines: false });
  (mesh.material as HatchingMaterial).vertexColors = true;
  return mesh;
}

const draw = async (meshes: readonly Mesh[], options: DrawSVGOptions = {}) =>
  drawSVG(sceneOf(...meshes), cameraAt(0.1, 0.3, 1), { kind: 'pen', sheet: [80, 80], shadows: false, ...options });

/** The labels of the layers of a file, and the horizontal middle of each, in shares of the sheet. */
function layersOf(svg: string): { label: string; middle: number; stroke: string; width: number }[] {
  return [
    ...svg.matchAll(
      /inkscape:label="([^"]+)" fill="none" stroke="(#\w+)" stroke-width="([\d.]+)"[^>]*>\n([\s\S]*?)<\/g>/g,
    ),
  ].map(([, label, stroke, width, paths]) => {
    const starts = [...paths.matchAll(/d="M(-?[\d.]+)/g)].map(([, x]) => Number(x));
    return { label, stroke, width: Number(width), middle: starts.reduce((sum, x) => sum + x, 0) / starts.length / 80 };
  });
}

const PENS = [
  { color: 'black', width: 0.3 },
  { color: 'red', width: 0.5 },
  { color: '#0000ff', width: 0.2, name: 'ink of my pen', speed: 40 },
];

describe('pens of a plotter', () => {
  test('the colours of surfaces are matched to those of the pens, and each pen has one layer, in their order', async () => {
    const meshes = [
      await ball('left', -0.6, '#a01010'),
      await ball('middle', 0, '#888888'),
      await ball('right', 0.6, '#2030c0'),
    ];
    const { svg, layers, plotSeconds } = await draw(meshes, { pens: PENS });
    const found = layersOf(svg);
    expect(found.map(({ label, stroke, width }) => [label, stroke, width])).toEqual([
      ['1 - black 0.3', '#000000', 0.3],
      ['!2 - red 0.5', '#ff0000', 0.5],
      ['!3+S40 - ink of my pen 0.2', '#0000ff', 0.2],
    ]);
    const [black, red, blue] = found.map(({ middle }) => middle);
    expect(red).toBeLessThan(black - 0.1);
    expect(blue).toBeGreaterThan(black + 0.1);
    expect(layers.map(({ name, ink, pen }) => [name, ink, pen])).toEqual([
      ['black 0.3', '#000000', 0.3],
      ['red 0.5', '#ff0000', 0.5],
      ['ink of my pen 0.2', '#0000ff', 0.2],
    ]);
    expect(plotSeconds).toBeCloseTo(
      layers.reduce((sum, layer) => sum + layer.plotSeconds!, 0),
      6,
    );
  });

  test('a note tells of the pens in a layer that plotters leave out, below words of its user', async () => {
    const mesh = await ball('one', 0, 'white');
    const plain = await draw([mesh], { pens: PENS });
    const noted = await draw([mesh], { pens: PENS, note: 'a < b\n2nd line' });
    const [, label, text] = /<g id="note"[^>]* inkscape:label="([^"]+)"[^>]*>([\s\S]*?)<\/g>\n/.exec(noted.svg)!;
    expect(label).toBe('% note');
    const lines = [...text.matchAll(/<text x="([\d.]+)" y="([\d.]+)">(.*?)<\/text>/g)];
    const [{ paths, drawn }] = noted.layers;
    expect(lines.map(([, , , line]) => line)).toEqual([
      'a &#60; b',
      '2nd line',
      `black 0.3: 0.3 mm, ${paths.toLocaleString('en')} paths, ${(drawn / 1000).toFixed(2)} m, about 1 min`,
    ]);
    // All lines lie in the lower margin, one below the other.
    const heights = lines.map(([, , y]) => Number(y));
    expect(Math.min(...heights)).toBeGreaterThan(70);
    expect(Math.max(...heights)).toBeLessThan(80);
    expect(new Set(heights).size).toBe(3);
    expect(noted.svg.replace(/<g id="note"[\s\S]*?<\/g>\n/, '')).toBe(plain.svg);
  });

  test('a mesh of several colours is shared among pens', async () => {
    const found = layersOf((await draw([await twoColoured()], { pens: PENS })).svg);
    expect(found.map(({ label }) => label.replace(/^!?\d+(\+S\d+)? - /, ''))).toEqual(['red 0.5', 'ink of my pen 0.2']);
    expect(found[0].middle).toBeLessThan(0.5);
    expect(found[1].middle).toBeGreaterThan(0.5);
  });

  test('a thicker pen draws fewer lines of the same tone', async () => {
    const mesh = await ball('one', 0, 'white');
    const inkOf = async (width: number) => {
      const { layers } = await draw([mesh], { pens: [{ color: 'black', width }] });
      return { drawn: layers[0].drawn, ink: layers[0].drawn * width };
    };
    const [thin, thick] = [await inkOf(0.2), await inkOf(0.4)];
    expect(thick.drawn).toBeLessThan(0.65 * thin.drawn);
    expect(Math.abs(thick.ink / thin.ink - 1)).toBeLessThan(0.2);
  });

  test.each<['part' | 'material', string[]]>([
    ['part', ['left #000000 0.3', 'right #000000 0.3']],
    ['material', ['left paint #000000 0.3', 'right paint #000000 0.3']],
  ])('each %s has a layer of its own', async (pens, names) => {
    const meshes = [await ball('left', -0.6, 'white'), await ball('right', 0.6, 'white')];
    const { svg, layers } = await draw(meshes, { pens });
    expect(layers.map(({ name }) => name)).toEqual(names);
    const [left, right] = layersOf(svg);
    expect(left.middle).toBeLessThan(0.5);
    expect(right.middle).toBeGreaterThan(0.5);
    // One pen draws both, so the plotter does not wait.
    expect(right.label).toBe(`2 - ${names[1]}`);
  });

  test('each ink has one layer for all kinds of lines', async () => {
    const mesh = await ball('one', 0, 'white', '#123456');
    expect((await draw([mesh])).layers.length).toBeGreaterThan(1);
    const { layers } = await draw([mesh], { pens: 'ink' });
    expect(layers.map(({ name }) => name)).toEqual(['#123456 0.3']);
  });

  test('a name with characters of XML leaves a file that can be parsed', async () => {
    const mesh = await ball('<b> & "c"\u0007', 0, 'white');
    const { svg } = await draw([mesh], { pens: 'part' });
    expect(svg).toContain('1 - &#60;b&#62; &#38; &#34;c&#34; ');
  });
});

test('a layer pauses after the metres of a filling', async () => {
  const mesh = await ball('one', 0, 'white');
  const whole = await draw([mesh], { pens: 'ink' });
  const { svg } = await draw([mesh], { pens: 'ink', refill: whole.drawn / 1000 / 2.5 });
  const labels = layersOf(svg).map(({ label }) => label);
  expect(labels.length).toBeGreaterThanOrEqual(3);
  expect(labels.map((label) => label.startsWith('!'))).toEqual(labels.map((_, i) => i > 0));
  const pathsOf = (text: string) => [...text.matchAll(/<path d="([^"]+)"/g)].map(([, data]) => data);
  expect(pathsOf(svg)).toEqual(pathsOf(whole.svg));
});

test('each pen has a file of its own with split', async () => {
  const meshes = [await ball('left', -0.6, 'red'), await ball('right', 0.6, 'black')];
  const { svg, files } = await draw(meshes, { pens: PENS, split: 'pen' });
  expect(files.map(({ name }) => name)).toEqual(['black 0.3', 'red 0.5']);
  const pathsOf = (text: string) => [...text.matchAll(/<path d="([^"]+)"/g)].map(([, data]) => data);
  expect(files.flatMap((file) => pathsOf(file.svg))).toEqual(pathsOf(svg));
});

test('a DXF file holds the paths in millimetres on named layers', async () => {
  const { dxf, layers } = await draw([await ball('one', 0, 'white')], { dxf: true, sheet: [80, 60] });
  const read = new DxfParser().parseSync(dxf!)!;
  expect(Object.keys(read.tables.layer.layers)).toEqual(expect.arrayContaining(['HATCH']));
  expect(read.entities.length).toBe(layers.reduce((sum, { paths }) => sum + paths, 0));
  const polylines = read.entities as unknown as {
    type: string;
    shape: boolean;
    vertices: { x: number; y: number }[];
  }[];
  let drawn = 0;
  for (const { type, shape: isClosed, vertices } of polylines) {
    expect(type).toBe('POLYLINE');
    for (const { x, y } of vertices) {
      expect(x).toBeGreaterThan(0);
      expect(x).toBeLessThan(80);
      expect(y).toBeGreaterThan(0);
      expect(y).toBeLessThan(60);
    }
    for (let i = isClosed ? 0 : 1; i < vertices.length; i++) {
      const [from, to] = [vertices.at(i - 1)!, vertices[i]];
      drawn += Math.hypot(to.x - from.x, to.y - from.y);
    }
  }
  expect(drawn / layers.reduce((sum, layer) => sum + layer.drawn, 0)).toBeCloseTo(1, 2);
});
