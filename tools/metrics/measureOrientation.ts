import { SphereGeometry, TorusKnotGeometry } from 'three';
import { bakeCorners } from '../../src/mesh/bake/bakeCorners.js';
import { computeAreaNormals, doubleArea } from '../../src/mesh/computeAreaNormals.js';
import { consistentPatches, NO_PATCH, type Patches } from '../../src/mesh/orientation/consistentPatches.js';
import { measureParts } from '../../src/mesh/orientation/measureParts.js';
import { orientTriangles } from '../../src/mesh/orientation/orientTriangles.js';
import { sideVotes } from '../../src/mesh/orientation/sideVotes.js';
import { runToEnd } from '../../src/mesh/phases.js';
import type { TriangleMesh } from '../../src/mesh/TriangleMesh.js';
import { weldPositions } from '../../src/mesh/weldPositions.js';
import { random } from '../../src/strokes/random.js';
import { CLOSED, OPEN, TRAPS, turned } from './orientationModels.js';

/** Shares of the area of a model that face the wrong way after it was oriented. */
export interface OrientationRow {
  model: string;
  kind: 'closed' | 'open' | 'trap';
  triangles: number;
  patches: number;
  /** Of the model as it is. */
  right: number;
  /** Of the model turned inside out; of traps undefined, for whose inverse may be right, too. */
  inverted?: number;
  /** With 30 % of the patches turned, chosen by chance: the mean of several choices. */
  ofPatches?: number;
  /** With 30 % of the triangles turned. */
  ofTriangles?: number;
  /** The share of the area that is seen about as much from both sides, which does not count as wrong. */
  eitherSide?: number;
  /** The greatest share of the area of a part that is wrong, of models of several parts, in any of these. */
  worstPart?: number;
}

/** The share of triangles, or of patches, that are turned. */
const SHARE = 0.3;
const CHOICES = 3;

/** Measures the orientation of every model, or of some. */
export async function measureOrientation(names: readonly string[] = []): Promise<OrientationRow[]> {
  const rows: OrientationRow[] = [];
  for (const [kind, models] of [
    ['closed', CLOSED],
    ['open', OPEN],
    ['trap', TRAPS],
  ] as const) {
    for (const [model, make] of Object.entries(models)) {
      if (!make || (names.length > 0 && !names.includes(model))) continue;
      rows.push({ model, kind, ...measure(await make(), kind === 'trap') });
    }
  }
  return rows;
}

function measure(mesh: TriangleMesh, isTrap: boolean): Omit<OrientationRow, 'model' | 'kind'> {
  const { canonical } = runToEnd(weldPositions(mesh.positions));
  const areaNormals = runToEnd(computeAreaNormals(mesh));
  const corners = mesh.indices.map((vertex) => canonical[vertex]);
  const { patchOf, doubleAreas } = runToEnd(consistentPatches(corners, areaNormals));
  const all = doubleAreas.reduce((sum, area) => sum + area, 0);
  const isEither = eitherSide(mesh, runToEnd(consistentPatches(corners, areaNormals)), areaNormals);
  const wrong = (isTurned: Uint8Array): { share: number; worst: number } => {
    const found = runToEnd(orientTriangles(turned(mesh, isTurned)));
    const areas = doubleAreas.map(() => 0);
    for (let triangle = 0; triangle < found.length; triangle++) {
      if (patchOf[triangle] !== NO_PATCH && found[triangle] !== isTurned[triangle])
        areas[patchOf[triangle]] += doubleArea(areaNormals, triangle);
    }
    if (!isTrap) for (const [patch, either] of isEither.entries()) if (either) areas[patch] = 0;
    const share = areas.reduce((sum, area) => sum + area, 0) / all;
    return { share, worst: Math.max(...areas.map((area, patch) => area / doubleAreas[patch])) };
  };
  const count = mesh.indices.length / 3;
  const right = wrong(new Uint8Array(count)).share;
  const row = { triangles: count, patches: doubleAreas.length, right };
  if (isTrap) return row;
  const next = random(1);
  const choose = (isTurned: (triangle: number) => boolean) =>
    wrong(Uint8Array.from({ length: count }, (_, i) => Number(isTurned(i))));
  const inverted = choose(() => true);
  const ofTriangles = Array.from({ length: CHOICES }, () => choose(() => next() < SHARE));
  const ofPatches = Array.from({ length: CHOICES }, () => {
    const isTurned = doubleAreas.map(() => next() < SHARE);
    return choose((triangle) => patchOf[triangle] !== NO_PATCH && isTurned[patchOf[triangle]]);
  });
  const mean = (all: { share: number }[]) => all.reduce((sum, { share }) => sum + share, 0) / all.length;
  const worst = Math.max(...[inverted, ...ofTriangles, ...ofPatches].map((one) => one.worst));
  return {
    ...row,
    inverted: inverted.share,
    ofPatches: mean(ofPatches),
    ofTriangles: mean(ofTriangles),
    eitherSide: doubleAreas.reduce((sum, area, patch) => sum + (isEither[patch] ? area : 0), 0) / all,
    ...(doubleAreas.length > 1 && { worstPart: worst }),
  };
}

/** The least share of the votes for one side, of those for the other, with which an open patch is seen from both sides. */
const BOTH = 0.5;

/** For each patch whether it is open, and seen about as much from one side as from the other, or from neither. */
function eitherSide(mesh: TriangleMesh, patches: Patches, areaNormals: Float64Array): boolean[] {
  const { front, back } = runToEnd(sideVotes(mesh, patches, measureParts(mesh, areaNormals, patches)));
  return patches.isClosed.map(
    (isClosed, i) => !isClosed && Math.min(front[i], back[i]) >= BOTH * Math.max(front[i], back[i]),
  );
}

/** The time of the orientation of a mesh, and of the bake that the page does of it, in milliseconds of processor time. */
interface OrientationTime {
  mesh: string;
  triangles: number;
  orientation: number;
  bake: number;
}

/** Runs of which the shortest counts. */
const RUNS = 5;

/** Times a closed and an open mesh of 100,000 triangles. */
export function timeOrientation(): OrientationTime[] {
  const timed = {
    closed: new TorusKnotGeometry(1, 0.3, 1020, 50),
    open: new SphereGeometry(1, 320, 160, 0, 5.5),
    'open, inside out': new SphereGeometry(1, 320, 160, 0, 5.5).scale(-1, 1, 1),
  };
  return Object.entries(timed).map(([name, { attributes, index }]) => {
    const mesh = {
      positions: new Float32Array(attributes.position.array),
      indices: Uint32Array.from(index!.array),
    };
    const bake = shortest(() =>
      runToEnd(
        bakeCorners({
          mesh: { positions: mesh.positions.slice(), indices: mesh.indices.slice() },
          label: name,
          creaseAngle: Math.PI / 2,
          smoothingRadius: undefined,
          weldTolerance: undefined,
          wantsNormals: true,
          outlines: { triangleGroups: null },
          form: null,
          attributes: [],
        }),
      ),
    );
    const orientation = shortest(() => runToEnd(orientTriangles(mesh)));
    return { mesh: name, triangles: mesh.indices.length / 3, orientation, bake };
  });
}

function shortest(run: () => void): number {
  const times = Array.from({ length: RUNS }, () => {
    const before = process.cpuUsage();
    run();
    return process.cpuUsage(before).user / 1000;
  });
  return Math.min(...times);
}
