import { isSeenFromBehind } from '../orientation/seenFromBehind.js';
import { asPhase, chunkPhase } from '../phases.js';
import { weldPositions } from '../weldPositions.js';
import {
  BACK,
  FRONT,
  MAP_SIZE,
  NO_SAMPLE,
  type OcclusionMesh,
  type OcclusionScene,
  type OcclusionView,
} from './OcclusionScene.js';
import { samplesWithin } from './samplesWithin.js';

/**
 * Lift of samples off their surface along the normal, in pixels. A map holds the depth at the middle of a pixel, which is at most 0.71
 * pixels from the sample. There a plane of any slope is at most that far above the sample, along the normal.
 */
const LIFT = 1;
/** Distance in pixels by which samples at a border are moved inwards, out of walls that meet the surface there. */
const INWARD = 1.5;

/** Transforms all meshes to world space and chooses the samples and views. At least one mesh must have normals. */
export function* startOcclusion({ meshes }: { meshes: OcclusionMesh[] }): Generator<number, OcclusionScene, void> {
  const surfaces: OcclusionSurface[] = [];
  for (const [i, mesh] of meshes.entries()) {
    surfaces.push(yield* asPhase(sampleSurface(mesh), i / (meshes.length + 1), (i + 1) / (meshes.length + 1)));
  }
  const occluders = surfaces
    .map(({ positions, indices }, i) => ({
      positions,
      indices,
      occluding: meshes[i].occluding,
      isMirrored: determinantOf(meshes[i].toWorld) < 0,
    }))
    .filter(({ occluding }) => occluding.some((sides) => sides !== 0));
  const sampled = surfaces.flatMap(({ samples }) => samples ?? []);
  const sides = [...sampled, ...sampled.filter(({ hasBack }) => hasBack).map(backOf)];
  const positions = joined(
    Float32Array,
    occluders.map(({ positions }) => positions),
  );
  const triangles = joinedTriangles(occluders);
  const isOpen = yield* asPhase(letsLightIn(positions, triangles), meshes.length / (meshes.length + 1), 1);
  if (!isOpen) triangles.twoSided = triangles.indices.length / 3;
  const scene = {
    ...triangles,
    positions,
    samplePositions: joined(
      Float32Array,
      sides.map(({ positions }) => positions),
    ),
    sampleNormals: joined(
      Float32Array,
      sides.map(({ normals }) => normals),
    ),
    sampleOf: sampled.map(({ sampleOf }) => sampleOf),
    backAfter: [] as number[],
  };
  const fronts = countOf(sampled);
  const backAfter = new Uint32Array(fronts);
  let first = 0;
  let firstOfBack = fronts;
  for (const { sampleOf, positions, hasBack } of sampled) {
    for (let i = 0; i < sampleOf.length; i++) if (sampleOf[i] !== NO_SAMPLE) sampleOf[i] += first;
    const after = hasBack ? firstOfBack - first : 0;
    scene.backAfter.push(after);
    const count = positions.length / 3;
    backAfter.fill(after, first, first + count);
    first += count;
    if (hasBack) firstOfBack += count;
  }
  // Chosen by fronts alone: where one side is drawn, backs elsewhere change nothing.
  const views = chooseViews(scene.samplePositions.subarray(0, 3 * fronts));
  for (const view of views) view.samples = withBacks(view.samples, backAfter);
  const inward = joined(
    Float32Array,
    sides.map((samples) => samples.inward),
  );
  for (const { radius, samples } of views) {
    const pixel = (2 * radius) / MAP_SIZE;
    for (const sample of samples) {
      for (let i = 3 * sample; i < 3 * sample + 3; i++) {
        scene.samplePositions[i] += pixel * (LIFT * scene.sampleNormals[i] + INWARD * inward[i]);
      }
    }
  }
  const { within, standsFor, standIns } = yield* samplesWithin(
    meshes.filter(({ normals }) => normals !== null),
    { ...scene, views },
  );
  addToViews(views, within, firstOfBack);
  return {
    ...scene,
    samplePositions: joined(Float32Array, [scene.samplePositions, Float32Array.from(within)]),
    sampleNormals: joined(Float32Array, [scene.sampleNormals, pick(scene.sampleNormals, Uint32Array.from(standIns))]),
    standsFor: Uint32Array.from(standsFor),
    standIns: Uint32Array.from(standIns),
    sums: new Float32Array(2 * (firstOfBack + standIns.length)),
    views,
  };
}

/** Adds samples to the view of the bulk where they lie in it, and others to the view of what lies far out. @param first number of the first */
function addToViews(views: readonly OcclusionView[], positions: readonly number[], first: number): void {
  const [{ center, radius }] = views;
  const isNear = (sample: number): boolean =>
    Math.hypot(...center.map((middle, axis) => positions[3 * (sample - first) + axis] - middle)) < radius;
  const added = Uint32Array.from({ length: positions.length / 3 }, (_, i) => first + i);
  for (const [i, view] of views.entries()) {
    const own = views.length === 1 ? added : added.filter((sample) => isNear(sample) === (i === 0));
    view.samples = joined<typeof own>(Uint32Array, [view.samples, own]);
  }
}

/** The samples of the back of a surface, in the order of those of its front. */
const backOf = (front: SurfaceSamples): SurfaceSamples => ({ ...front, normals: front.normals.map((value) => -value) });

const countOf = (sets: readonly SurfaceSamples[]): number =>
  sets.reduce((sum, { positions }) => sum + positions.length / 3, 0);

/** Adds the samples of backs to those of fronts. backAfter: how far after each front its back is, 0 for none */
function withBacks(fronts: Uint32Array<ArrayBuffer>, backAfter: Uint32Array): Uint32Array<ArrayBuffer> {
  const backs = fronts.filter((sample) => backAfter[sample] > 0).map((sample) => sample + backAfter[sample]);
  return backs.length > 0 ? joined<Uint32Array<ArrayBuffer>>(Uint32Array, [fronts, backs]) : fronts;
}

/** Concatenates arrays. */
function joined<A extends Float32Array | Uint32Array>(Type: new (length: number) => A, arrays: readonly A[]): A {
  const whole = new Type(arrays.reduce((sum, { length }) => sum + length, 0));
  let offset = 0;
  for (const array of arrays) {
    whole.set(array, offset);
    offset += array.length;
  }
  return whole;
}

/** A mesh that occludes, in world space. */
interface Occluder extends Pick<OcclusionMesh, 'positions' | 'indices' | 'occluding'> {
  /** Whether its matrix turns counter-clockwise triangles clockwise. */
  isMirrored: boolean;
}

/** Joins the triangles of several meshes, and shifts their indices to the joined vertices. */
function joinedTriangles(occluders: readonly Occluder[]): Pick<OcclusionScene, 'indices' | 'twoSided'> {
  let twoSided = 0;
  let oneSided = 0;
  for (const { occluding } of occluders) {
    for (const sides of occluding) {
      if (sides === FRONT + BACK) twoSided++;
      else if (sides !== 0) oneSided++;
    }
  }
  const joined = new Uint32Array(3 * (twoSided + oneSided));
  let [two, one, first] = [0, 3 * twoSided, 0];
  for (const { positions, indices, occluding, isMirrored } of occluders) {
    for (let triangle = 0; triangle < occluding.length; triangle++) {
      const sides = occluding[triangle];
      if (sides === 0) continue;
      const isTurned = sides !== FRONT + BACK && (sides === BACK) !== isMirrored;
      const corner = 3 * triangle;
      const at = sides === FRONT + BACK ? two : one;
      joined[at] = first + indices[corner];
      joined[at + 1] = first + indices[isTurned ? corner + 2 : corner + 1];
      joined[at + 2] = first + indices[isTurned ? corner + 1 : corner + 2];
      if (sides === FRONT + BACK) two += 3;
      else one += 3;
    }
    first += positions.length / 3;
  }
  return { indices: joined, twoSided };
}

/**
 * Whether light falls through the backs of surfaces with one side, as the eye does: where most that is seen of them from around are backs, as
 * of a room whose walls face inward. Through an open sheet or a scan with holes no light falls.
 */
function* letsLightIn(
  positions: Float32Array<ArrayBuffer>,
  { indices, twoSided }: Pick<OcclusionScene, 'indices' | 'twoSided'>,
): Generator<number, boolean, void> {
  const oneSided = indices.subarray(3 * twoSided);
  return oneSided.length > 0 && (yield* isSeenFromBehind({ positions, indices: oneSided }));
}

/** The determinant of the upper left 3×3 part of a matrix. */
const determinantOf = ([a, b, c, , d, e, f, , g, h, i]: readonly number[]): number =>
  a * (e * i - f * h) - d * (b * i - c * h) + g * (b * f - c * e);

/** The share of the samples that count as the bulk of the scene. */
const BULK = 0.98;
/** Samples that lie this many times farther out than the bulk get depth maps of their own. */
const FARTHER = 1.5;
/** The radius of a view is this many times the distance of its farthest sample, which leaves a margin in the map. */
const MARGIN = 1.02;

/**
 * Chooses one view around all samples, or two: if a few samples lie far out, such as the corners of a wide ground, they get a
 * view of their own, so that the bulk of the scene is measured at a finer resolution.
 *
 * @param positions x, y, z of each sample
 */
function chooseViews(positions: Float32Array): OcclusionView[] {
  const count = positions.length / 3;
  const center = [0, 1, 2].map((axis) => {
    const along = new Float32Array(count);
    for (let i = 0; i < count; i++) along[i] = positions[3 * i + axis];
    along.sort();
    const end = count - 1;
    // The middle of the bulk, regardless of a few samples far out.
    return (along[Math.round((1 - BULK) * end)] + along[Math.round(BULK * end)]) / 2;
  }) as OcclusionView['center'];
  const distances = new Float32Array(count);
  for (let i = 0; i < count; i++) {
    distances[i] = Math.hypot(
      positions[3 * i] - center[0],
      positions[3 * i + 1] - center[1],
      positions[3 * i + 2] - center[2],
    );
  }
  const sorted = distances.slice().sort();
  const limit = FARTHER * sorted[Math.round(BULK * (count - 1))];
  const near = sorted.findLast((distance) => distance <= limit) ?? 0;
  const view = (reach: number, isIn: (distance: number) => boolean): OcclusionView => ({
    center,
    radius: MARGIN * reach || 1,
    samples: Uint32Array.from(distances.keys()).filter((i) => isIn(distances[i])),
  });
  const far = sorted[count - 1];
  if (far === near) return [view(far, () => true)];
  return [view(near, (distance) => distance <= near), view(far, (distance) => distance > near)];
}

/** A mesh in world space that has every position only once. */
interface OcclusionSurface {
  positions: Float32Array<ArrayBuffer>;
  indices: Uint32Array<ArrayBuffer>;
  samples: SurfaceSamples | null;
}

/** The samples of a mesh: every pair of position and normal among its vertices, without repetition. */
interface SurfaceSamples {
  positions: Float32Array<ArrayBuffer>;
  normals: Float32Array<ArrayBuffer>;
  /** A tangent vector that points away from the border: of length 1 at a straight border, near 0 in the interior. */
  inward: Float32Array<ArrayBuffer>;
  /** For each vertex its sample, or NO_SAMPLE. */
  sampleOf: Uint32Array<ArrayBuffer>;
  /** Whether the occlusion of the back is measured too. */
  hasBack: boolean;
}

/** Welds vertices at the same position, since geometries prepared for hatching may have three vertices per triangle. */
function* sampleSurface(mesh: OcclusionMesh): Generator<number, OcclusionSurface, void> {
  const { indices, normals, toWorld, sides } = mesh;
  const { canonical } = yield* asPhase(weldPositions(mesh.positions), 0, 0.3);
  const places = numbered(canonical, indices);
  const surface = {
    positions: toWorldPoints(pick(mesh.positions, places.firsts), toWorld),
    indices: indices.map((vertex) => places.numbers[vertex]),
  };
  yield 0.4;
  if (normals === null) return { ...surface, samples: null };

  const turned = yield* asPhase(weldPositions(normals), 0.4, 0.6);
  const pairs = new Uint32Array(normals.length);
  for (let vertex = 0; vertex < canonical.length; vertex++) {
    pairs[3 * vertex] = canonical[vertex];
    pairs[3 * vertex + 1] = turned.canonical[vertex];
  }
  // Vertices with equal pairs are welded too: only bits are compared, so integers may stand in for floats.
  const both = yield* asPhase(weldPositions(new Float32Array(pairs.buffer)), 0.6, 0.8);
  const { firsts, numbers } = numbered(both.canonical, indices);
  const samples = {
    positions: toWorldPoints(pick(mesh.positions, firsts), toWorld),
    normals: toWorldNormals(pick(normals, firsts), toWorld, sides === 'back' ? -1 : 1),
    inward: new Float32Array(3 * firsts.length),
    sampleOf: numbers,
    hasBack: sides === 'both',
  };
  yield* chunkPhase(indices.length / 3, 0.8, 1, (start, end) => addInward(samples, indices, start, end));
  limitInward(samples);
  return { ...surface, samples };
}

/**
 * Numbers the canonical vertices that triangles use, from 0 on.
 *
 * @returns for each vertex its number or NO_SAMPLE, and for each number its canonical vertex
 */
function numbered(canonical: Uint32Array, indices: Uint32Array) {
  const numbers = new Uint32Array(canonical.length).fill(NO_SAMPLE);
  const firsts = new Uint32Array(canonical.length);
  let count = 0;
  for (const vertex of indices) {
    const first = canonical[vertex];
    if (numbers[first] === NO_SAMPLE) {
      firsts[count] = first;
      numbers[first] = count++;
    }
    numbers[vertex] = numbers[first];
  }
  return { numbers, firsts: firsts.subarray(0, count) };
}

function pick(triples: Float32Array, vertices: Uint32Array): Float32Array<ArrayBuffer> {
  const picked = new Float32Array(3 * vertices.length);
  for (let i = 0; i < vertices.length; i++) {
    picked[3 * i] = triples[3 * vertices[i]];
    picked[3 * i + 1] = triples[3 * vertices[i] + 1];
    picked[3 * i + 2] = triples[3 * vertices[i] + 2];
  }
  return picked;
}

/** Adds up the unit vectors from each sample to the middles of its triangles. */
function addInward({ positions, inward, sampleOf }: SurfaceSamples, indices: Uint32Array, start: number, end: number) {
  for (let corner = 3 * start; corner < 3 * end; corner += 3) {
    const a = 3 * sampleOf[indices[corner]];
    const b = 3 * sampleOf[indices[corner + 1]];
    const c = 3 * sampleOf[indices[corner + 2]];
    const x = (positions[a] + positions[b] + positions[c]) / 3;
    const y = (positions[a + 1] + positions[b + 1] + positions[c + 1]) / 3;
    const z = (positions[a + 2] + positions[b + 2] + positions[c + 2]) / 3;
    for (let k = 0; k < 3; k++) {
      const sample = k === 0 ? a : k === 1 ? b : c;
      const u = x - positions[sample];
      const v = y - positions[sample + 1];
      const w = z - positions[sample + 2];
      const length = Math.sqrt(u * u + v * v + w * w);
      if (!(length > 0)) continue;
      inward[sample] += u / length;
      inward[sample + 1] += v / length;
      inward[sample + 2] += w / length;
    }
  }
}

/** Projects each vector into the tangent plane, and shortens it to length 1 if it is longer. */
function limitInward({ normals, inward }: SurfaceSamples): void {
  for (let i = 0; i < inward.length; i += 3) {
    const rise = inward[i] * normals[i] + inward[i + 1] * normals[i + 1] + inward[i + 2] * normals[i + 2];
    for (let axis = 0; axis < 3; axis++) inward[i + axis] -= rise * normals[i + axis];
    const length = Math.hypot(inward[i], inward[i + 1], inward[i + 2]);
    if (length <= 1) continue;
    for (let axis = 0; axis < 3; axis++) inward[i + axis] /= length;
  }
}

/**
 * Transforms points to world space.
 *
 * @param matrix the elements of the matrix, by columns
 */
function toWorldPoints(points: Float32Array, matrix: readonly number[]): Float32Array<ArrayBuffer> {
  const [m0, m1, m2, , m4, m5, m6, , m8, m9, m10, , m12, m13, m14] = matrix;
  const moved = new Float32Array(points.length);
  for (let i = 0; i < points.length; i += 3) {
    const x = points[i];
    const y = points[i + 1];
    const z = points[i + 2];
    moved[i] = m0 * x + m4 * y + m8 * z + m12;
    moved[i + 1] = m1 * x + m5 * y + m9 * z + m13;
    moved[i + 2] = m2 * x + m6 * y + m10 * z + m14;
  }
  return moved;
}

/**
 * Transforms normals to unit normals in world space. A normal without direction becomes zero.
 *
 * @param sign −1 reverses the normals
 */
function toWorldNormals(normals: Float32Array, matrix: readonly number[], sign: number): Float32Array<ArrayBuffer> {
  const [a, b, c, , d, e, f, , g, h, i] = matrix;
  // The cofactors are the inverse transpose times the determinant, of which only the sign matters.
  const turn = sign * Math.sign(determinantOf(matrix));
  const cofactors = [
    e * i - f * h,
    c * h - b * i,
    b * f - c * e,
    f * g - d * i,
    a * i - c * g,
    c * d - a * f,
    d * h - e * g,
    b * g - a * h,
    a * e - b * d,
  ];
  const turned = new Float32Array(normals.length);
  for (let k = 0; k < normals.length; k += 3) {
    const x = normals[k];
    const y = normals[k + 1];
    const z = normals[k + 2];
    const u = cofactors[0] * x + cofactors[1] * y + cofactors[2] * z;
    const v = cofactors[3] * x + cofactors[4] * y + cofactors[5] * z;
    const w = cofactors[6] * x + cofactors[7] * y + cofactors[8] * z;
    const length = Math.hypot(u, v, w);
    if (!(length > 0 && length < Infinity)) continue;
    turned[k] = (turn * u) / length;
    turned[k + 1] = (turn * v) / length;
    turned[k + 2] = (turn * w) / length;
  }
  return turned;
}
