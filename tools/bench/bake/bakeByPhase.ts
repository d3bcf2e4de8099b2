import {
  absorbSmallPatches,
  buildFans,
  computeAreaNormals,
  consistentTwins,
  cutCreases,
  cutSharpEdges,
  DEFAULT_SMOOTHING_SHARE,
  expandPerCorner,
  type FanNormals,
  fanDirections,
  findPatches,
  joinBorders,
  measureBounds,
  nearnessOf,
  packCornerAttributes,
  packCorners,
  packHatchNormals,
  packPull,
  pairEdges,
  type Surface,
  smoothFanNormals,
  splitVertices,
  type TriangleMesh,
  validateTriangleMesh,
  weldPositions,
} from '../internals.js';

type Run = <Result>(phase: string, task: Generator<number, Result, void>) => Result;

/**
 * The steps of `bake`, `bakePull` and `bakeIndexed` one by one, each handed to `run` under the name of its phase, for a mesh
 * that has normals and no other attributes. A unit test compares the results with those of the functions themselves.
 */
export function bakeByPhase(mesh: TriangleMesh, run: Run) {
  run('check', validateTriangleMesh(mesh, 'benchmark'));
  const bounds = run('check', measureBounds(mesh));
  const { canonical, steps: weldSteps } = run('weld', weldPositions(mesh.positions));
  const canonicalCorners = run('pair', canonicalOf(canonical, mesh.indices));
  const areaNormals = run('pair', computeAreaNormals(mesh));
  const pairing = run('pair', pairEdges(mesh.positions, canonicalCorners, areaNormals));
  const paired = { positions: mesh.positions, canonicalCorners, areaNormals, pairing };
  run('join', joinBorders(paired, nearnessOf(bounds)));
  const adjacency = {
    ...pairing,
    borderEdges: pairing.borders.length,
    canonicalCorners: paired.canonicalCorners,
    areaNormals,
    steps: weldSteps + pairing.steps,
  };
  run('creases', cutCreases(adjacency, Math.PI / 2));
  const twins = run('creases', consistentTwins(adjacency));
  run('creases', cutSharpEdges(twins, areaNormals));
  const hatchNormals = smoothNormals(
    { mesh, twins, canonicalCorners: paired.canonicalCorners, areaNormals },
    bounds.radius,
    run,
  );
  const surface: Surface = { adjacency, bounds, hatchNormals, smoothNormals: null, outlines: null, form: null };
  return {
    steps: adjacency.steps,
    corner: {
      ...run('pack corner', packCorners(mesh, adjacency.twins)),
      ...run('pack corner', packCornerAttributes(surface, mesh.indices, [])),
    },
    pull: packPulled(mesh, surface, run),
    indexed: packIndexed(mesh, surface, run),
  };
}

/** The same steps that `buildTriangleAdjacency` takes. */
// biome-ignore lint/correctness/useYield: one step, too short to be sliced.
function* canonicalOf(canonical: Uint32Array, indices: Uint32Array): Generator<number, Uint32Array<ArrayBuffer>, void> {
  const canonicalCorners = new Uint32Array(indices.length);
  for (let corner = 0; corner < indices.length; corner++) canonicalCorners[corner] = canonical[indices[corner]];
  return canonicalCorners;
}

type FanSurface = Pick<Surface['adjacency'], 'twins' | 'canonicalCorners' | 'areaNormals'> & { mesh: TriangleMesh };

function smoothNormals(faces: FanSurface, boundingRadius: number, run: Run): FanNormals {
  const radius = DEFAULT_SMOOTHING_SHARE * boundingRadius;
  const fans = run('normals', buildFans(faces.twins));
  const [smoothed] = run('normals', smoothFanNormals({ ...faces, fans }, [radius]));
  const patches = run('normals', findPatches(faces));
  run(
    'normals',
    absorbSmallPatches(faces, patches, fans, (area) => !(area >= Math.PI * (radius / 2) ** 2)),
  );
  return { fans, normals: run('normals', fanDirections(smoothed, faces.areaNormals, fans)) };
}

function packPulled({ positions, indices }: TriangleMesh, surface: Surface, run: Run) {
  const phase = 'pack pull';
  const packed = run(phase, packPull(positions, indices, surface.adjacency.twins));
  const words = new Uint32Array(positions.buffer);
  const expanded = run(phase, expandPerCorner({ words, wordsPerVertex: 3 }, indices));
  const ofCorners = run(phase, packCornerAttributes(surface, indices, []));
  return { ...packed, ...ofCorners, positions: new Float32Array(expanded.buffer) };
}

function packIndexed(mesh: TriangleMesh, { adjacency, hatchNormals }: Surface, run: Run) {
  const phase = 'pack indexed';
  const { indices, addedVertices, cornerOfVertex } = run(
    phase,
    splitVertices(mesh, adjacency.areaNormals, hatchNormals.fans),
  );
  return { indices, addedVertices, hatchNormals: run(phase, packHatchNormals(hatchNormals, cornerOfVertex)) };
}
