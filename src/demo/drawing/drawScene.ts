import { type AnimationClip, Box3, Group, type InstancedMesh, MathUtils, type Object3D, Vector3 } from 'three';
import { applyHatching, type HatchingStatistics } from 'three-hatching';
import { checkTriangleCount } from '../files/checkTriangleCount.js';
import { measureExtent } from '../files/fitModel.js';
import type { LiveScene } from '../files/parseGltf.js';
import { placements } from '../files/placements.js';
import { DrawnModel, type ModelFacts } from './DrawnModel.js';
import { Motion } from './Motion.js';
import { meshesOf } from './meshesOf.js';

/** Poses of a clip that are looked at for the room it takes, and vertices in all of them together: a skinned one costs a microsecond. */
const POSES = 8;
const MAX_POINTS = 20_000;

/** A scene ready to be drawn, and what of it could not be. */
export interface DrawnScene {
  model: DrawnModel;
  /** Parts and clips with numbers in them that are none. */
  broken: number;
}

/**
 * Makes a drawing of a scene that keeps its parts: surfaces with their pictures, skins, shapes and clips. What is no surface
 * is not drawn, and lights are the page's own.
 *
 * @throws ModelError with one sentence for the person at the page
 */
export async function drawScene(
  { root, animations }: LiveScene,
  options: { signal: AbortSignal; onProgress: (progress: number) => void },
): Promise<DrawnScene> {
  const sound = animations.filter(isSound);
  hideOthers(root);
  const motion = new Motion(root, sound);
  const holder = new Group().add(root);
  const bounds = fitScene(holder, motion);

  // One tile per unit of the fitted world; the settings say how many there are to be.
  const hatched = await applyHatching(root, { tonalArtMap: null, strokeScale: 1, ...options });
  for (const { mesh } of hatched.skipped) mesh.visible = false;
  for (const mesh of meshesOf(root)) {
    // Its bounds are those of the pose it was measured in.
    if ('isSkinnedMesh' in mesh || mesh.morphTargetInfluences) mesh.frustumCulled = false;
  }
  const model = new DrawnModel(
    holder,
    bounds,
    factsOf(root),
    motion.isPossible ? motion : undefined,
    hatched.materials,
    () => {
      motion.dispose();
      hatched.dispose();
    },
  );
  return { model, broken: hatched.skipped.length + animations.length - sound.length };
}

const isSound = ({ tracks, duration }: AnimationClip): boolean =>
  duration < Infinity &&
  tracks.every(({ times, values }) => times.every(Number.isFinite) && values.every(Number.isFinite));

function hideOthers(root: Object3D): void {
  root.traverse((object) => {
    if ('isLight' in object || 'isLine' in object || 'isPoints' in object) object.visible = false;
  });
}

/**
 * Moves and scales what `holder` holds, so that it is centred and its farthest vertex, in all poses of the clip that were
 * looked at, lies at distance 1.
 *
 * @returns the bounds of all these poses
 */
function fitScene(holder: Group, motion: Motion): Box3 {
  const vertices = countVertices(holder);
  const poses = motion.duration > 0 ? MathUtils.clamp(Math.floor(MAX_POINTS / vertices), 1, POSES) : 1;
  const step = Math.ceil((vertices * poses) / MAX_POINTS);
  const points: number[] = [];
  for (let i = 0; i < poses; i++) {
    motion.time = (i / poses) * motion.duration;
    holder.updateMatrixWorld(true);
    addPoints(holder, step, points);
  }
  motion.time = 0;
  const { centre, radius } = measureExtent(Float32Array.from(points));
  holder.scale.setScalar(1 / radius);
  holder.position.set(...centre).divideScalar(-radius);
  holder.updateMatrixWorld(true);
  return new Box3().setFromArray(points).applyMatrix4(holder.matrixWorld);
}

/** Where every so many vertices of all parts are, as they stand now. */
function addPoints(holder: Group, step: number, points: number[]): void {
  const point = new Vector3();
  for (const mesh of meshesOf(holder)) {
    const count = mesh.geometry.getAttribute('position')?.count ?? 0;
    for (const matrix of placements(mesh)) {
      for (let i = 0; i < count; i += step) {
        mesh.getVertexPosition(i, point).applyMatrix4(matrix);
        // A broken vertex belongs to a part that is left out.
        if (Number.isFinite(point.x + point.y + point.z)) points.push(point.x, point.y, point.z);
      }
    }
  }
}

/** @throws ModelError if there is nothing to draw, or too much */
function countVertices(holder: Group): number {
  let vertices = 0;
  let triangles = 0;
  for (const mesh of meshesOf(holder)) {
    const { geometry } = mesh;
    const count = geometry.getAttribute('position')?.count ?? 0;
    const times = 'isInstancedMesh' in mesh ? (mesh as InstancedMesh).count : 1;
    vertices += count * times;
    triangles += ((geometry.index?.count ?? count) / 3) * times;
  }
  checkTriangleCount(vertices > 0 ? triangles : 0);
  return vertices;
}

/** Sums over the parts; shared and repeated ones count as often as they are drawn. */
function factsOf(root: Object3D): ModelFacts {
  const facts: ModelFacts = { triangles: 0, borderEdges: 0, nonManifoldEdges: 0, degenerateTriangles: 0 };
  for (const mesh of meshesOf(root)) {
    const statistics = mesh.geometry.userData.hatching as HatchingStatistics | undefined;
    if (!mesh.visible || !statistics) continue;
    for (const key of Object.keys(facts) as (keyof ModelFacts)[])
      facts[key] += statistics[key] * placements(mesh).length;
  }
  return facts;
}
