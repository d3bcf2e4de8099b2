import { combined, dot, type Vec3 } from '../look/vectors.js';
import type { DrawnScene } from './DrawnScene.js';
import { type LineSurface, STRIDE, WORLD } from './LineSurface.js';
import type { Matrix } from './Projection.js';
import type { Clip, ClipPlane } from './paint/PaintLook.js';
import type { ObjectFading } from './shading/fading.js';

/** Distance from the origin, in sizes of the scene, from which on a scene is moved. */
const FAR = 100;

/**
 * Moves a scene that lies far away to the origin, with its camera and lights: the boxes of the hierarchy are in single precision, and
 * heights at which rays start depend on coordinates.
 */
export function moveToOrigin(scene: DrawnScene): DrawnScene {
  const centre = centreOf(scene.corners);
  if (!centre) return scene;
  const { camera, corners, surfaces, stippled, outlines, cutouts, illumination } = scene;
  const back: Vec3 = [-centre[0], -centre[1], -centre[2]];
  for (let i = 0; i < corners.length; i++) corners[i] += back[i % 3];
  for (const { vertices } of new Set<LineSurface>([...surfaces, ...stippled].map(({ surface }) => surface)))
    for (let o = WORLD; o < vertices.length; o += STRIDE) for (let k = 0; k < 3; k++) vertices[o + k] += back[k];
  const movedLook = <Look extends { fading: ObjectFading | null }>(look: Look): Look => ({
    ...look,
    fading: movedFading(look.fading, back),
  });
  const moved = <Drawn extends { look: { fading: ObjectFading | null }; clip: Clip | null }>(drawn: Drawn): Drawn => ({
    ...drawn,
    look: movedLook(drawn.look),
    clip: movedClip(drawn.clip, centre),
  });
  return {
    ...scene,
    camera: { ...camera, world: placedBy(camera.world, back), view: beforehand(camera.view, centre) },
    surfaces: surfaces.map(moved),
    stippled: stippled.map(moved),
    outlines: outlines.map(moved).map((outlined) => ({
      ...outlined,
      mesh: { ...outlined.mesh, toWorld: placedBy(outlined.mesh.toWorld, back) },
    })),
    cutouts: cutouts.map((cutout) => ({
      ...cutout,
      clip: movedClip(cutout.clip, centre),
      shadowClip: movedClip(cutout.shadowClip, centre),
    })),
    illumination: {
      ...illumination,
      lamps: illumination.lamps.map((lamp) => (lamp.isFar ? lamp : { ...lamp, at: combined(1, lamp.at, 1, back) })),
    },
  };
}

/** The centre of triangles that lie far from the origin; otherwise undefined. */
function centreOf(corners: Float64Array): Vec3 | undefined {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < corners.length; i++) {
    const axis = i % 3;
    if (corners[i] < low[axis]) low[axis] = corners[i];
    if (corners[i] > high[axis]) high[axis] = corners[i];
  }
  const centre = low.map((value, axis) => (value + high[axis]) / 2) as [number, number, number];
  const size = Math.hypot(...low.map((value, axis) => high[axis] - value));
  return Math.hypot(...centre) > FAR * size && size > 0 ? centre : undefined;
}

/** A matrix to world space, followed by the translation. */
function placedBy(matrix: Matrix, way: Vec3): Matrix {
  const placed = Array.from(matrix);
  for (let k = 0; k < 3; k++) placed[12 + k] += way[k];
  return placed;
}

/** A matrix from world space, preceded by the translation. */
function beforehand(m: Matrix, [x, y, z]: Vec3): Matrix {
  const moved = Array.from(m);
  for (let k = 0; k < 3; k++) moved[12 + k] += m[k] * x + m[4 + k] * y + m[8 + k] * z;
  return moved;
}

function movedClip(clip: Clip | null, centre: Vec3): Clip | null {
  const moved = ([x, y, z, d]: ClipPlane): ClipPlane => [x, y, z, d + dot([x, y, z], centre)];
  return clip && { each: clip.each.map(moved), together: clip.together.map(moved) };
}

const movedFading = (fading: ObjectFading | null, way: Vec3): ObjectFading | null =>
  fading?.focus ? { ...fading, focus: { ...fading.focus, at: combined(1, fading.focus.at, 1, way) } } : fading;
