import type { BufferGeometry, Mesh, Object3D } from 'three';
import { VRMLLoader } from 'three/addons/loaders/VRMLLoader.js';
import { ModelError } from '../common/ModelError.js';
import { withFakeDocument } from './fakeDocument.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { repairFans } from './repairFans.js';

/** Reads a VRML 2 file. @throws ModelError if it contains unsupported nodes; Error of the loader */
export function readVrml(bytes: Uint8Array, name: string): LoadedScene {
  const text = new TextDecoder().decode(bytes);
  if (/^[^#"\n\r]*\b(?:EXTERN)?PROTO\b/m.test(text))
    throw new ModelError(`${name} defines nodes of its own (PROTO), which this page does not read.`);
  const plain = plainVrml(text);
  const root = withFakeDocument(() => new VRMLLoader().parse(plain.text, ''));
  if (!root) return sceneOf(root, name);
  repairFans(root);
  if (!/\b(?:creaseAngle|Normal)\b/.test(text)) root.traverse(withoutNormals);
  return { ...sceneOf(root, name), notes: plain.notes };
}

/**
 * Removes the flat normals that the loader computes for face sets without normals and crease angle. They are computed later, with creases
 * kept.
 */
function withoutNormals(object: Object3D): void {
  const { geometry } = object as Partial<Mesh>;
  if ((geometry as (BufferGeometry & { _type?: string }) | undefined)?._type === 'mesh')
    geometry!.deleteAttribute('normal');
}

/** A token: a word, a quoted text, or the numbers of a list; or the content of brackets. */
type Item = string | Group;

interface Group {
  open: '{' | '[';
  items: Item[];
}

type Field = { at: number; numbers: number[] };

const MAX_DEPTH = 500;
const CLOSES = { '{': '}', '[': ']' } as const;
const TOKEN = /"(?:[^"\\]|\\.)*"|#[^\n\r]*|[{}[\]]|[^\s,{}[\]"#]+/g;
/** A list of numbers, of which files contain millions. */
const NUMBERS = /[-+.\d\s,eE]*\]/y;
/** Nodes that are not drawn, and their notes for the caption. */
const LEFT_OUT: Readonly<Record<string, string>> = {
  Inline: 'parts in other files left out',
  Text: 'text left out',
};
/** Nodes and fields that three's loader misreads or ignores. */
const ODD = /\b(?:Billboard|ElevationGrid|Inline|LOD|Switch|Text|center|scaleOrientation)\b/;

/**
 * Rewrites a VRML file for three's loader, which ignores LOD, switch and inline nodes and the centres and orientations of transforms, and
 * mirrors elevation grids.
 *
 * @returns the text, and notes for the caption on nodes that are not drawn
 */
export function plainVrml(text: string): { text: string; notes: string[] } {
  const items = ODD.test(text) ? itemsOf(text) : undefined;
  if (!items) return { text, notes: [] };
  const notes = new Set<string>();
  const [head] = /^[^\n\r]*/.exec(text)!;
  return { text: `${head}\n${written(plainItems(items, notes))}`, notes: [...notes] };
}

/** Parses the content of a file; undefined if its brackets do not match, or are nested too deep. */
function itemsOf(text: string): Item[] | undefined {
  const open: Group[] = [{ open: '[', items: [] }];
  const token = new RegExp(TOKEN);
  for (let found = token.exec(text); found; found = token.exec(text)) {
    const [word] = found;
    const { open: kind, items } = open[open.length - 1];
    if (word.startsWith('#')) continue;
    if (word === '{' || word === '[') {
      const group: Group = { open: word, items: [] };
      items.push(group);
      NUMBERS.lastIndex = token.lastIndex;
      const [numbers] = (word === '[' && NUMBERS.exec(text)) || [''];
      if (numbers) {
        group.items.push(numbers.slice(0, -1));
        token.lastIndex += numbers.length;
      } else if (open.push(group) > MAX_DEPTH) return undefined;
    } else if (word === '}' || word === ']') {
      if (open.length === 1 || CLOSES[kind] !== word) return undefined;
      open.pop();
    } else items.push(word);
  }
  return open.length === 1 ? open[0].items : undefined;
}

const written = (items: readonly Item[]): string =>
  items
    .map((item) => (typeof item === 'string' ? item : `${item.open} ${written(item.items)} ${CLOSES[item.open]}`))
    .join(' ');

const isBody = (item: Item | undefined): item is Group => typeof item === 'object' && item.open === '{';

function plainItems(items: readonly Item[], notes: Set<string>): Item[] {
  const plain: Item[] = [];
  for (let i = 0; i < items.length; i++) {
    const [item, next] = [items[i], items[i + 1]];
    if (typeof item === 'string' && isBody(next)) {
      if (LEFT_OUT[item]) notes.add(LEFT_OUT[item]);
      plain.push(...plainNode(item, plainItems(next.items, notes)));
      i++;
    } else plain.push(typeof item === 'string' ? item : { ...item, items: plainItems(item.items, notes) });
  }
  return plain;
}

function plainNode(name: string, body: Item[]): Item[] {
  switch (name) {
    case 'Transform':
      return node(name, plainTransform(body));
    case 'Billboard':
      return node('Group', body);
    case 'LOD':
      return node('Group', ['children', list(nodesOf(body, 'level')[0] ?? [])]);
    case 'Switch':
      return node('Group', [
        'children',
        list(nodesOf(body, 'choice')[takeNumbers(body, 'whichChoice', 1)?.[0] ?? -1] ?? []),
      ]);
    case 'ElevationGrid':
      return node('IndexedFaceSet', facesOfGrid(body));
    default:
      return node(name, body);
  }
}

const node = (name: string, items: Item[]): Item[] => [name, { open: '{', items }];
const list = (items: Item[]): Group => ({ open: '[', items });

/** The nodes in a field, with or without names. */
function nodesOf(body: readonly Item[], field: string): Item[][] {
  const at = body.findIndex((item) => item === field || item === 'children');
  const value = at === -1 ? undefined : body[at + 1];
  const items = typeof value === 'object' ? value.items : body.slice(at + 1);
  const nodes: Item[][] = [];
  let begun: Item[] = [];
  for (const item of at === -1 ? [] : items) {
    begun.push(item);
    const isUse = begun.length === 2 && begun[0] === 'USE';
    if (!isBody(item) && !isUse && item !== 'NULL') continue;
    nodes.push(item === 'NULL' ? [] : begun);
    begun = [];
  }
  return nodes;
}

function fieldOf(body: readonly Item[], name: string, count: number): Field | undefined {
  const at = body.indexOf(name);
  const numbers = body.slice(at + 1, at + 1 + count).map(Number);
  return at !== -1 && numbers.length === count && numbers.every(Number.isFinite) ? { at, numbers } : undefined;
}

/** Removes a field's numbers from a node and returns them. */
function takeNumbers(body: Item[], name: string, count: number): number[] | undefined {
  const field = fieldOf(body, name, count);
  if (field) body.splice(field.at, count + 1);
  return field?.numbers;
}

/** Splits a transform with centre and scale orientation into nested transforms without them. */
function plainTransform(body: Item[]): Item[] {
  if (!fieldOf(body, 'center', 3) && !fieldOf(body, 'scaleOrientation', 4)) return body;
  const inner = [...body];
  const centre = takeNumbers(inner, 'center', 3) ?? [0, 0, 0];
  const [x, y, z, angle] = takeNumbers(inner, 'scaleOrientation', 4) ?? [0, 0, 1, 0];
  const place = takeNumbers(inner, 'translation', 3) ?? [0, 0, 0];
  const turn = takeNumbers(inner, 'rotation', 4) ?? [0, 0, 1, 0];
  const scale = takeNumbers(inner, 'scale', 3) ?? [1, 1, 1];
  const around = (fields: Item[], content: Item[]): Item[] => [...fields, 'children', list(node('Transform', content))];
  const words = (name: string, numbers: readonly number[]): Item[] => [name, ...numbers.map(String)];
  const moved = [
    ...words(
      'translation',
      centre.map((value) => -value),
    ),
    ...inner,
  ];
  const straight = around(words('rotation', [x, y, z, -angle]), moved);
  const scaled = around([...words('rotation', [x, y, z, angle]), ...words('scale', scale)], straight);
  const placed = words(
    'translation',
    place.map((value, axis) => value + centre[axis]),
  );
  return around([...placed, ...words('rotation', turn)], scaled);
}

/** The faces of an elevation grid: rows along x, stacked along z. */
function facesOfGrid(body: Item[]): Item[] {
  const fields = [...body];
  const take = (name: string, otherwise: number): number => takeNumbers(fields, name, 1)?.[0] ?? otherwise;
  const [columns, rows, width, depth] = [
    take('xDimension', 0),
    take('zDimension', 0),
    take('xSpacing', 1),
    take('zSpacing', 1),
  ];
  const at = fields.indexOf('height');
  const [, heights] = at === -1 ? [] : fields.splice(at, 2);
  const values = typeof heights === 'object' ? written(heights.items).match(/[^\s,]+/g) : null;
  if (!values || values.length < columns * rows) return fields;
  const points = values
    .slice(0, columns * rows)
    .map((y, i) => `${width * (i % columns)} ${y} ${depth * Math.floor(i / columns)}`);
  const faces: string[] = [];
  for (let row = 0; row + 1 < rows; row++) {
    for (let column = 0; column + 1 < columns; column++) {
      const corner = row * columns + column;
      faces.push(`${corner} ${corner + columns} ${corner + columns + 1} ${corner + 1} -1`);
    }
  }
  return [
    ...fields,
    'coord',
    ...node('Coordinate', ['point', list([points.join(', ')])]),
    'coordIndex',
    list([faces.join(' ')]),
  ];
}
