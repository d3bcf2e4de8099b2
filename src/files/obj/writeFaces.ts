import { triangulatePolygon } from '../mesh/triangulatePolygon.js';

/** A face of more than three corners. */
const POLYGON = /^[ \t]*f(?:[ \t]+\S+){4}/m;
/** A face with a corner that has no normal. */
const PLAIN = /^[ \t]*f(?:[ \t]+\S+)*?[ \t]+-?\d+(?:\/-?\d*)?\/?(?:[ \t]|$)/m;
/** The material of faces before the first one that the file names: three's loader would give them that one. */
const NO_MATERIAL = 'usemtl (none)';
/** Smoothing groups are told apart by up to so many numbers. */
const GROUPS = 2 ** 20;

/**
 * Writes the faces of an OBJ file, as `cleanObj` leaves it, for three's loader, which cuts polygons as fans, over their notches, and takes
 * every face without normals for flat. Polygons become triangles. Faces without normals are smooth within their smoothing group and flat
 * where smoothing is off; where the file says nothing their normals are zero, so that they are computed later, with edges kept.
 */
export function writeFaces(text: string): string {
  if (!POLYGON.test(text) && !PLAIN.test(text) && !beginsBare(text)) return text;
  const { data, drawn, positions, normals } = readLines(text);
  const smooth = new SmoothNormals(positions, normals + 1);
  eachFace(drawn, (corners, group) => {
    if (group > 0 && corners.some(lacksNormal)) smooth.add(corners, group);
  });
  const zero = normals + smooth.count + 1;
  const written: string[] = [];
  eachFace(
    drawn,
    (corners, group) => {
      const complete = corners.map((corner) => {
        if (!lacksNormal(corner) || group === 0) return corner;
        return withNormal(corner, group === -1 ? zero : smooth.numberOf(corner, group));
      });
      if (corners.length === 3) written.push(`f ${complete.join(' ')}`);
      else {
        const triangles = triangulatePolygon(pointsOf(corners, positions));
        for (let i = 0; i < triangles.length; i += 3)
          written.push(`f ${complete[triangles[i]]} ${complete[triangles[i + 1]]} ${complete[triangles[i + 2]]}`);
      }
    },
    (line) => written.push(line),
  );
  return [...data, ...smooth.lines(), 'vn 0 0 0', NO_MATERIAL, ...written].join('\n');
}

/** Whether faces come before the material of others. */
function beginsBare(text: string): boolean {
  const named = text.search(/^usemtl /m);
  return named !== -1 && text.slice(0, named).search(/^[ \t]*f[ \t]/m) !== -1;
}

/** A file in parts: what faces refer to comes before all of them, and their numbers count from the beginning of the file. */
interface ObjLines {
  /** The vertices, texture coordinates and normals. */
  data: string[];
  /** The faces, and what they are drawn with. */
  drawn: string[];
  /** xyz of the vertices. */
  positions: number[];
  /** The number of normals. */
  normals: number;
}

function readLines(text: string): ObjLines {
  const data: string[] = [];
  const drawn: string[] = [];
  const positions: number[] = [];
  const counts = { v: 0, vt: 0, vn: 0 };
  for (const raw of text.split('\n')) {
    const line = raw.trim();
    if (line.startsWith('v')) {
      const [kind, ...numbers] = line.split(/[ \t]+/);
      counts[kind as keyof typeof counts]++;
      if (kind === 'v') for (let axis = 0; axis < 3; axis++) positions.push(Number.parseFloat(numbers[axis]));
      data.push(line);
    } else if (line.startsWith('f')) drawn.push(line.includes('-') ? fromBeginning(line, counts) : line);
    else if (line !== '') drawn.push(line);
  }
  return { data, drawn, positions, normals: counts.vn };
}

/** Replaces numbers that count backwards from the last vertex before the face. */
function fromBeginning(line: string, { v, vt, vn }: Readonly<Record<'v' | 'vt' | 'vn', number>>): string {
  const totals = [v, vt, vn];
  return line.replace(/[^ \t/]+|\/|[ \t]+/g, scan(totals));
}

/** Counts which number of a corner comes next. */
function scan(totals: readonly number[]): (part: string) => string {
  let place = 0;
  return (part) => {
    if (part === '/') place++;
    else if (/^[ \t]/.test(part)) place = 0;
    else if (part.startsWith('-')) return String(totals[place] + 1 + Number.parseInt(part, 10));
    return part;
  };
}

/**
 * Calls back with the corners of each face and its smoothing group: 0 where smoothing is off, -1 where the file has said nothing.
 *
 * @param onOther called with every other line
 */
function eachFace(
  lines: readonly string[],
  onFace: (corners: string[], group: number) => void,
  onOther: (line: string) => void = () => {},
): void {
  let group = -1;
  for (const line of lines) {
    if (line.startsWith('f'))
      onFace(
        line
          .slice(1)
          .trim()
          .split(/[ \t]+/),
        group,
      );
    else if (/^s(?:[ \t]|$)/.test(line)) group = groupOf(line.slice(1).trim());
    else onOther(line);
  }
}

/** Some programs write the word alone, and some `on`. */
function groupOf(name: string): number {
  if (/^(?:0|off|null)$/i.test(name)) return 0;
  return 1 + ((Number.parseInt(name, 10) || 1) % (GROUPS - 1));
}

/** Whether a corner such as `1`, `1/2` or `1/2/` names no normal. */
function lacksNormal(corner: string): boolean {
  const second = corner.indexOf('/', corner.indexOf('/') + 1);
  return !corner.includes('/') || second === -1 || second === corner.length - 1;
}

function withNormal(corner: string, number: number): string {
  const [vertex, coordinates = ''] = corner.split('/');
  return `${vertex}/${coordinates}/${number}`;
}

const vertexOf = (corner: string): number => Number.parseInt(corner, 10) - 1;

function pointsOf(corners: readonly string[], positions: readonly number[]): number[] {
  return corners.flatMap((corner) => {
    const at = 3 * vertexOf(corner);
    return [positions[at] ?? NaN, positions[at + 1] ?? NaN, positions[at + 2] ?? NaN];
  });
}

const cross = ([ux, uy, uz]: readonly number[], [vx, vy, vz]: readonly number[]): number[] => [
  uy * vz - uz * vy,
  uz * vx - ux * vz,
  ux * vy - uy * vx,
];

/** The normals of vertices in their smoothing groups: the mean of the faces that meet there, by their angles. */
class SmoothNormals {
  private readonly numbers = new Map<number, number>();
  private readonly sums: number[] = [];

  /** @param first the number of the first of them in the file */
  constructor(
    private readonly positions: readonly number[],
    private readonly first: number,
  ) {}

  get count(): number {
    return this.numbers.size;
  }

  add(corners: readonly string[], group: number): void {
    const points = pointsOf(corners, this.positions);
    const count = corners.length;
    const face = [0, 0, 0];
    const turns: number[] = [];
    const from = (corner: number, to: number): number[] =>
      [0, 1, 2].map((axis) => points[3 * (to % count) + axis] - points[3 * corner + axis]);
    for (let i = 0; i < count; i++) {
      const [u, v] = [from(i, i + 1), from(i, i + count - 1)];
      turns.push(Math.atan2(Math.hypot(...cross(u, v)), u[0] * v[0] + u[1] * v[1] + u[2] * v[2]));
      for (const [axis, value] of cross(from(0, i), from(0, i + 1)).entries()) face[axis] += value;
    }
    const length = Math.hypot(...face);
    for (const [i, corner] of corners.entries()) {
      const at = 3 * this.placeOf(corner, group);
      if (!(length > 0 && length < Infinity)) continue;
      for (let axis = 0; axis < 3; axis++) this.sums[at + axis] += (turns[i] * face[axis]) / length;
    }
  }

  /** The number of the normal of a corner in the file. */
  numberOf(corner: string, group: number): number {
    return this.first + this.placeOf(corner, group);
  }

  lines(): string[] {
    return Array.from({ length: this.count }, (_, i) => `vn ${this.sums.slice(3 * i, 3 * i + 3).join(' ')}`);
  }

  private placeOf(corner: string, group: number): number {
    const key = GROUPS * vertexOf(corner) + group;
    let place = this.numbers.get(key);
    if (place === undefined) {
      place = this.numbers.size;
      this.numbers.set(key, place);
      this.sums.push(0, 0, 0);
    }
    return place;
  }
}
