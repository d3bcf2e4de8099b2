import { forEachChunk } from '../../phases.js';
import type { FormSurface } from '../FormSurface.js';
import { FRAME_FLOATS } from './connection.js';
import type { DirectionField } from './directionField.js';

/** A direction per face. Its sign means nothing until `cutForm` has combed the faces. */
export interface FaceDirections {
  /** Three floats per face: the unit direction across the lines, in which φ rises. */
  across: Float32Array<ArrayBuffer>;
  /** Three floats per face: the unit normal that `across` is perpendicular to, the mean of its fans' normals. */
  normals: Float32Array<ArrayBuffer>;
}

/** Normals whose sum is shorter cancel each other; the face then takes the normal of its first fan. */
const LEAST_SUM = 1e-6;

/** Largest cosine between a fan's tangent and the normal of the face; beyond it the other tangent starts the frame. */
const LARGEST_COSINE = 0.8;

/** Carries a field of lines from the fans to the faces: the mean of the lines of each face's fans, turned by 90°. */
export function* faceDirections(
  { fans, normals }: Pick<FormSurface, 'fans' | 'normals'>,
  { lines, frames }: DirectionField,
): Generator<number, FaceDirections, void> {
  const { ofCorner, count } = fans;
  const tangents = new Float32Array(3 * count);
  yield* forEachChunk(count, (start, end) => tangentRange(lines, frames, tangents, start, end));
  const directions = { across: new Float32Array(ofCorner.length), normals: new Float32Array(ofCorner.length) };
  yield* forEachChunk(ofCorner.length / 3, (start, end) =>
    directRange(ofCorner, normals, frames, tangents, directions, start, end),
  );
  return directions;
}

/** Writes for each fan a tangent along its line. The square of its length is the certainty of the line. */
function tangentRange(
  lines: Float64Array,
  frames: Float32Array,
  tangents: Float32Array,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const x = lines[2 * fan];
    const y = lines[2 * fan + 1];
    const length = Math.sqrt(x * x + y * y);
    // Half of the angle, by the half-angle formulas.
    const cosine = Math.sqrt(Math.max(0, 0.5 * (length + x)));
    const sine = Math.sqrt(Math.max(0, 0.5 * (length - x))) * (y < 0 ? -1 : 1);
    const i = FRAME_FLOATS * fan;
    tangents[3 * fan] = cosine * frames[i] + sine * frames[i + 3];
    tangents[3 * fan + 1] = cosine * frames[i + 1] + sine * frames[i + 4];
    tangents[3 * fan + 2] = cosine * frames[i + 2] + sine * frames[i + 5];
  }
}

function directRange(
  ofCorner: Uint32Array,
  fanNormals: Float32Array,
  frames: Float32Array,
  tangents: Float32Array,
  { across, normals }: FaceDirections,
  start: number,
  end: number,
): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    const a = 3 * ofCorner[first];
    const b = 3 * ofCorner[first + 1];
    const c = 3 * ofCorner[first + 2];
    let nx = fanNormals[a] + fanNormals[b] + fanNormals[c];
    let ny = fanNormals[a + 1] + fanNormals[b + 1] + fanNormals[c + 1];
    let nz = fanNormals[a + 2] + fanNormals[b + 2] + fanNormals[c + 2];
    let size = Math.sqrt(nx * nx + ny * ny + nz * nz);
    if (size < LEAST_SUM) {
      nx = fanNormals[a];
      ny = fanNormals[a + 1];
      nz = fanNormals[a + 2];
      size = 1;
    }
    nx /= size;
    ny /= size;
    nz /= size;
    // The frame of the face: u is a tangent of the first fan, pressed into the face; v = n × u.
    let i = (FRAME_FLOATS / 3) * a;
    if (Math.abs(frames[i] * nx + frames[i + 1] * ny + frames[i + 2] * nz) > LARGEST_COSINE) i += 3;
    let ux = frames[i];
    let uy = frames[i + 1];
    let uz = frames[i + 2];
    const height = ux * nx + uy * ny + uz * nz;
    ux -= height * nx;
    uy -= height * ny;
    uz -= height * nz;
    const flat = 1 / (Math.sqrt(ux * ux + uy * uy + uz * uz) || 1);
    ux *= flat;
    uy *= flat;
    uz *= flat;
    const vx = ny * uz - nz * uy;
    const vy = nz * ux - nx * uz;
    const vz = nx * uy - ny * ux;
    let x = 0;
    let y = 0;
    for (let corner = first; corner < first + 3; corner++) {
      const t = 3 * ofCorner[corner];
      const along = tangents[t] * ux + tangents[t + 1] * uy + tangents[t + 2] * uz;
      const beside = tangents[t] * vx + tangents[t + 1] * vy + tangents[t + 2] * vz;
      x += along * along - beside * beside;
      y += 2 * along * beside;
    }
    // Half of the angle, plus a quarter turn: across the line.
    const length = Math.sqrt(x * x + y * y) || 1;
    const cosine = -Math.sqrt(Math.max(0, 0.5 * (1 - x / length))) * (y < 0 ? -1 : 1);
    const sine = Math.sqrt(Math.max(0, 0.5 * (1 + x / length)));
    across[first] = cosine * ux + sine * vx;
    across[first + 1] = cosine * uy + sine * vy;
    across[first + 2] = cosine * uz + sine * vz;
    normals[first] = nx;
    normals[first + 1] = ny;
    normals[first + 2] = nz;
  }
}
