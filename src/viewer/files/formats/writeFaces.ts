import { fanNormal, isFan, triangulatePolygon } from '../mesh/triangulatePolygon.js';

/** A face of more than three corners. */
const POLYGON = /^[ \t]*f(?:[ \t]+\S+){4}/m;
/** A face with a corner that has no normal. */
const PLAIN = /^[ \t]*f(?:[ \t]+\S+)*?[ \t]+-?\d+(?:\/-?\d*)?\/?(?:[ \t]|$)/m;
/** The material of faces before the first `usemtl`; three's loader would give them the first named material. */
const NO_MATERIAL = 'usemtl (none)';
const BLANKS = /[ \t]+/;
/** The maximum number of distinct smoothing groups. */
const GROUPS = 2 ** 20;

/**
 * Rewrites the faces of an OBJ file, cleaned by `cleanObj`, for three's loader, which triangulates concave polygons wrongly as fans and
 * makes every face without normals flat. Concave polygons become triangles. Faces without normals are smooth within their smoothing group
 * and flat where smoothing is off; where the file does not say, their normals are zero, so that they are computed later with creases kept.
 */
export function writeFaces(text: string): string {
  if (!POLYGON.test(text) && !PLAIN.test(text) && !beginsBare(text)) return text;
  const { data, drawn, positions, normals } = readLines(text);
  const smooth = new SmoothNormals(positions, normals + 1);
  eachFace(drawn, (_, face, group) => {
    if (group > 0 && face.lacksNormals) smooth.add(face, group);
  });
  const zero = normals + smooth.count + 1;
  const written: string[] = [];
  eachFace(
    drawn,
    (line, face, group) => {
      const isWhole = face.count < 4 || isFan(positions, face.vertices, face.count);
      if (isWhole && (group === 0 || !face.lacksNormals)) {
        written.push(line);
        return;
      }
      const corners = cornersOf(line);
      if (group !== 0 && face.lacksNormals) {
        for (let i = 0; i < corners.length; i++) {
          if (!lacksNormal(corners[i])) continue;
          corners[i] = withNormal(corners[i], group === -1 ? zero : smooth.numberOf(face.vertices[i], group));
        }
      }
      if (isWhole) {
        written.push(`f ${corners.join(' ')}`);
        return;
      }
      const triangles = triangulatePolygon(face.pointsOf(positions));
      for (let i = 0; i < triangles.length; i += 3)
        written.push(`f ${corners[triangles[i]]} ${corners[triangles[i + 1]]} ${corners[triangles[i + 2]]}`);
    },
    (line) => written.push(line),
  );
  return [...data, ...smooth.lines(), 'vn 0 0 0', NO_MATERIAL, ...written].join('\n');
}

/** Whether faces come before the first material. */
function beginsBare(text: string): boolean {
  const named = text.search(/^usemtl /m);
  return named !== -1 && text.slice(0, named).search(/^[ \t]*f[ \t]/m) !== -1;
}

/** An OBJ file split in two: vertex data first, then the faces, whose indices count from the beginning of the file. */
interface ObjLines {
  /** Lines of vertices, texture coordinates and normals. */
  data: string[];
  /** Lines of faces and their materials. */
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
    if (line.startsWith('vt')) counts.vt++;
    else if (line.startsWith('vn')) counts.vn++;
    else if (line.startsWith('v')) {
      counts.v++;
      const numbers = line.split(BLANKS, 4);
      for (let axis = 1; axis < 4; axis++) positions.push(Number.parseFloat(numbers[axis]));
    } else {
      if (line !== '') drawn.push(line.startsWith('f') && line.includes('-') ? fromBeginning(line, counts) : line);
      continue;
    }
    data.push(line);
  }
  return { data, drawn, positions, normals: counts.vn };
}

/** Replaces negative indices, which count backwards from the last vertex before the face. */
function fromBeginning(line: string, { v, vt, vn }: Readonly<Record<'v' | 'vt' | 'vn', number>>): string {
  const totals = [v, vt, vn];
  const counted = (number: string, place: number): string =>
    number.startsWith('-') ? String(totals[place] + 1 + Number.parseInt(number, 10)) : number;
  return `f ${cornersOf(line)
    .map((corner) => corner.split('/').map(counted).join('/'))
    .join(' ')}`;
}

/**
 * Calls back with each face and its smoothing group: 0 where smoothing is off, -1 where the file does not say. The `Face` object is reused.
 *
 * @param onOther called with every other line
 */
function eachFace(
  lines: readonly string[],
  onFace: (line: string, face: Face, group: number) => void,
  onOther: (line: string) => void = () => {},
): void {
  const face = new Face();
  let group = -1;
  for (const line of lines) {
    if (line.startsWith('f')) {
      face.read(line);
      onFace(line, face, group);
    } else if (/^s(?:[ \t]|$)/.test(line)) group = groupOf(line.slice(1).trim());
    else onOther(line);
  }
}

/** Some programs write `s` without a value, and some `s on`. */
function groupOf(name: string): number {
  if (/^(?:0|off|null)$/i.test(name)) return 0;
  return 1 + ((Number.parseInt(name, 10) || 1) % (GROUPS - 1));
}

const cornersOf = (line: string): string[] => line.slice(1).trim().split(BLANKS);

/** Whether a corner such as `1`, `1/2` or `1/2/` has no normal index. */
function lacksNormal(corner: string): boolean {
  const second = corner.indexOf('/', corner.indexOf('/') + 1);
  return !corner.includes('/') || second === -1 || second === corner.length - 1;
}

function withNormal(corner: string, number: number): string {
  const [vertex, coordinates = ''] = corner.split('/');
  return `${vertex}/${coordinates}/${number}`;
}

const [TAB, BLANK, SLASH, ZERO] = [9, 32, 47, 48];

/** A parsed face, reused for each line since files have millions. */
class Face {
  /** The indices of its vertices, from 0. */
  readonly vertices: number[] = [];
  count = 0;
  /** Whether any corner has no normal. */
  lacksNormals = false;

  read(line: string): void {
    this.count = 0;
    this.lacksNormals = false;
    for (let at = 1; at < line.length; at++) {
      let code = line.charCodeAt(at);
      if (code === BLANK || code === TAB) continue;
      let [vertex, slashes, digits] = [0, 0, 0];
      for (; at < line.length && code !== BLANK && code !== TAB; code = line.charCodeAt(++at)) {
        if (code === SLASH) {
          slashes++;
          digits = 0;
        } else {
          if (slashes === 0) vertex = 10 * vertex + code - ZERO;
          digits++;
        }
      }
      if (slashes < 2 || digits === 0) this.lacksNormals = true;
      this.vertices[this.count++] = vertex - 1;
    }
  }

  pointsOf(positions: readonly number[]): number[] {
    return this.vertices
      .slice(0, this.count)
      .flatMap((vertex) => [0, 1, 2].map((axis) => positions[3 * vertex + axis] ?? NaN));
  }
}

/** Vertex normals by smoothing group: the mean of the adjacent faces' normals, weighted by angle. */
class SmoothNormals {
  private readonly numbers = new Map<number, number>();
  private readonly sums: number[] = [];
  /** Normal of the face being added. */
  private readonly normal: [number, number, number] = [0, 0, 0];

  /** @param first index of the first new normal in the file */
  constructor(
    private readonly positions: readonly number[],
    private readonly first: number,
  ) {}

  get count(): number {
    return this.numbers.size;
  }

  add({ vertices, count }: Face, group: number): void {
    const { sums, normal } = this;
    fanNormal(this.positions, vertices, count, normal);
    const length = Math.sqrt(normal[0] ** 2 + normal[1] ** 2 + normal[2] ** 2);
    for (let i = 0; i < count; i++) {
      const at = 3 * this.placeOf(vertices[i], group);
      if (!(length > 0 && length < Infinity)) continue;
      const weight = this.angleAt(vertices[(i + count - 1) % count], vertices[i], vertices[(i + 1) % count]) / length;
      for (let axis = 0; axis < 3; axis++) sums[at + axis] += weight * normal[axis];
    }
  }

  /** The index of a vertex's normal in the file. */
  numberOf(vertex: number, group: number): number {
    return this.first + this.placeOf(vertex, group);
  }

  lines(): string[] {
    const { sums } = this;
    const lines: string[] = [];
    for (let i = 0; i < sums.length; i += 3) lines.push(`vn ${sums[i]} ${sums[i + 1]} ${sums[i + 2]}`);
    return lines;
  }

  private angleAt(before: number, vertex: number, after: number): number {
    const { positions } = this;
    const [o, a, b] = [3 * vertex, 3 * before, 3 * after];
    let [dot, lengthA, lengthB] = [0, 0, 0];
    for (let axis = 0; axis < 3; axis++) {
      const [u, v] = [positions[a + axis] - positions[o + axis], positions[b + axis] - positions[o + axis]];
      dot += u * v;
      lengthA += u * u;
      lengthB += v * v;
    }
    const cosine = dot / Math.sqrt(lengthA * lengthB);
    return cosine >= -1 && cosine <= 1 ? Math.acos(cosine) : 0;
  }

  private placeOf(vertex: number, group: number): number {
    const key = GROUPS * vertex + group;
    let place = this.numbers.get(key);
    if (place === undefined) {
      place = this.numbers.size;
      this.numbers.set(key, place);
      this.sums.push(0, 0, 0);
    }
    return place;
  }
}
