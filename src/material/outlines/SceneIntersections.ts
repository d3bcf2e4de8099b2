import { Box3, type Camera, Matrix4, type Mesh, type Object3D, type Scene, type WebGLRenderer } from 'three';
import type { PackedSurface } from '../../mesh/intersections/intersectOutlines.js';
import { MOST_TRIANGLES, pairsOf } from '../../mesh/intersections/pairsOf.js';
import { runTask } from '../../worker/runTask.js';
import type { TaskOptions } from '../../worker/TaskOptions.js';
import { FrameStamp } from '../FrameStamp.js';
import { type OutlineData, outlineDataOf } from '../geometry/OutlineData.js';
import { type IntersectingOutlines, wantsIntersections } from './IntersectingOutlines.js';
import { MeetingLines, type NewPart, relativeTo } from './MeetingLines.js';
import { hasHoles, isLoose, NumberedPart, numberParts } from './NumberedPart.js';
import type { OutlinePart } from './OutlineParts.js';
import { type DrawnOutlines, type LineDrawer, ScreenLines } from './ScreenLines.js';

/** How long meshes rest before the lines between them are computed, milliseconds. */
const REST = 120;

/** Outlines whose lines of intersection are wanted, as they were last seen. */
interface Member {
  readonly lines: MeetingLines;
  /** The matrix of the mesh. */
  readonly matrix: Matrix4;
  readonly part: NumberedPart;
  data: OutlineData | undefined;
}

/** A mesh that takes part in a search. */
interface Searched {
  outlines: IntersectingOutlines;
  mesh: Mesh;
  data: OutlineData;
  lines: MeetingLines;
  part: NumberedPart;
}

/** The lines along which the meshes of one scene cut each other. They are computed once the meshes rest, and kept while they move together. */
class SceneIntersections {
  /** The members as the map of parts knows them. */
  parts: readonly NumberedPart[] = [];
  private readonly members = new Map<IntersectingOutlines, Member>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private search: Promise<void> | null = null;
  /** The frame in which it was last looked for parts that move. */
  private readonly looked = new FrameStamp();

  constructor(readonly root: Object3D) {}

  /** Whether parts move against each other. It is found out once in a frame, by the first outlines that ask. */
  beginsToMove(renderer: WebGLRenderer, camera: Camera): boolean {
    if (this.looked.isOf(renderer, camera)) return false;
    this.looked.note(renderer, camera);
    return numberParts(this.parts, this.root) > 1;
  }

  partOf(outlines: IntersectingOutlines): NumberedPart | undefined {
    return this.members.get(outlines)?.part;
  }

  /** Notes where a mesh is. Allocates nothing while it rests. */
  note(outlines: IntersectingOutlines): Member {
    const { matrixWorld, geometry } = outlines.mesh!;
    const data = outlineDataOf(geometry);
    const known = this.members.get(outlines);
    if (known && known.data === data && known.matrix.equals(matrixWorld)) return known;
    const member = known ?? { lines: linesOf(outlines), matrix: new Matrix4(), part: new NumberedPart(outlines), data };
    member.matrix.copy(matrixWorld);
    member.data = data;
    this.members.set(outlines, member);
    if (!known) this.parts = [...this.parts, member.part];
    clearTimeout(this.timer);
    this.timer = setTimeout(this.searchSoon, REST);
    return member;
  }

  /** Computes all lines that are not known. The scene is told if there are new ones. */
  async update(options: TaskOptions = {}): Promise<void> {
    clearTimeout(this.timer);
    await this.search?.catch(() => {});
    options.signal?.throwIfAborted();
    this.search = this.find(options).finally(() => {
      this.search = null;
    });
    await this.search;
  }

  private readonly searchSoon = (): void => {
    // What goes wrong here is a worker that died: the next movement tries again.
    this.update().catch(() => {});
  };

  private async find(options: TaskOptions): Promise<void> {
    const searched = this.searched();
    const places = searched.map(({ mesh }) => mesh.matrixWorld.clone());
    await this.findBetween(searched, options);
    for (const [i, { part, data }] of searched.entries()) part.noteSearch(places[i], data);
  }

  private async findBetween(searched: readonly Searched[], options: TaskOptions): Promise<void> {
    // What is seen through holds the lines: it is drawn last, and would lie over them.
    const pairs = pairsOf(searched.map(({ mesh }) => boxOf(mesh)))
      .map(([one, other]) =>
        isSeenThrough(searched[other]) && !isSeenThrough(searched[one]) ? [other, one] : [one, other],
      )
      .filter(([first, second]) => !searched[first].lines.knows(searched[second].outlines));
    if (pairs.length === 0) return;
    const used = [...new Set(pairs.flat())];
    const numbers = new Map(used.map((of, number) => [of, number]));
    const relatives = pairs.map(([first, second]) =>
      relativeTo(searched[second].mesh, searched[first].mesh, new Matrix4()),
    );
    const request = {
      surfaces: used.map((of) => packedSurface(searched[of])),
      pairs: pairs.flatMap(([first, second]) => [numbers.get(first)!, numbers.get(second)!]),
    };
    const { createWorker } = searched[used[0]].data;
    const found = await runTask('intersectOutlines', request, { createWorker, ...options });
    const points = new Map(found.map((one) => [one.pair, one.points]));
    for (const [i, [first, second]] of pairs.entries()) {
      const { lines, data } = searched[first];
      const { outlines, data: otherData } = searched[second];
      const ofPair = points.has(i) ? points.get(i)! : new Uint32Array(0);
      lines.set(outlines, data, otherData, relatives[i], ofPair);
      if (first !== second) searched[second].lines.keep((other) => other !== searched[first].outlines);
    }
    if (found.length > 0) this.root.dispatchEvent({ type: 'intersections' } as never);
  }

  /** The members that are still in the scene, do not deform, and are no pictures on cards. */
  private searched(): Searched[] {
    const kept = new Set<IntersectingOutlines>();
    const searched: Searched[] = [];
    for (const [outlines, member] of this.members) {
      const { mesh } = outlines;
      if (!mesh || topOf(mesh) !== this.root) {
        this.members.delete(outlines);
        continue;
      }
      kept.add(outlines);
      const data = outlineDataOf(mesh.geometry);
      if (data && data.triangleCount <= MOST_TRIANGLES && wantsIntersections(outlines) && isRigid(mesh)) {
        searched.push({ outlines, mesh, data, lines: member.lines, part: member.part });
      }
    }
    this.parts = [...this.members.values()].map(({ part }) => part);
    for (const { lines } of this.members.values()) lines.keep((other) => kept.has(other));
    return searched;
  }
}

const scenes = new WeakMap<Object3D, SceneIntersections>();
const held = new WeakMap<IntersectingOutlines, MeetingLines>();

function sceneOf(root: Object3D): SceneIntersections {
  let scene = scenes.get(root);
  if (!scene) {
    scene = new SceneIntersections(root);
    scenes.set(root, scene);
  }
  return scene;
}

function linesOf(outlines: IntersectingOutlines): MeetingLines {
  let lines = held.get(outlines);
  if (!lines) {
    lines = new MeetingLines(outlines);
    held.set(outlines, lines);
  }
  return lines;
}

function topOf(object: Object3D): Object3D {
  let top = object;
  while (top.parent !== null) top = top.parent;
  return top;
}

/** Whether a mesh has one shape and one place, and is no picture cut out of cards. */
function isRigid(mesh: Mesh): boolean {
  const { material, matrixWorld } = mesh;
  if ('isBatchedMesh' in mesh || isLoose(mesh)) return false;
  return matrixWorld.determinant() !== 0 && !(Array.isArray(material) ? material : [material]).every(hasHoles);
}

const isSeenThrough = ({ mesh: { material } }: Searched): boolean =>
  (Array.isArray(material) ? material[0] : material).transparent;

function boxOf({ geometry, matrixWorld }: Mesh): Float64Array | null {
  if (!geometry.boundingBox) geometry.computeBoundingBox();
  const { min, max } = new Box3().copy(geometry.boundingBox!).applyMatrix4(matrixWorld);
  const box = Float64Array.of(...min, ...max);
  return box.every(Number.isFinite) ? box : null;
}

/** A copy of what is drawn of a mesh, for the worker. */
function packedSurface({ data, mesh: { matrixWorld } }: Searched): PackedSurface {
  const { points, primitives, pointCount, triangleCount, edgeCount } = data;
  return {
    points: (points.image.data as Uint32Array<ArrayBuffer>).slice(),
    primitives: (primitives.image.data as Uint32Array<ArrayBuffer>).slice(),
    ...{ pointCount, triangleCount, edgeCount },
    toShared: [...matrixWorld.elements],
    fromShared: new Matrix4().copy(matrixWorld).invert().elements,
  };
}

/** The parts of outlines, and the lines where their mesh meets others, as far as they are known. */
export const withIntersections = (
  outlines: IntersectingOutlines,
  parts: readonly OutlinePart[],
  newPart: NewPart,
): readonly OutlinePart[] => sceneOf(topOf(outlines.mesh!)).note(outlines).lines.add(parts, newPart);

/** The code that draws lines between parts that move with one kind of renderer. */
export interface MovingCode {
  makeDrawer(renderer: WebGLRenderer): LineDrawer;
}

/** Fetches the code for a kind of renderer: one function for each kind. */
export type FetchMoving = () => Promise<MovingCode>;

const fetchOfWebGL: FetchMoving = () => import('./MovingLines.js');

/** The code that is there; null while it is fetched. */
const codes = new Map<FetchMoving, MovingCode | null>();
const screens = new WeakMap<WebGLRenderer, ScreenLines>();

/**
 * Draws the lines where the parts of a scene meet that move against each other, are instances or deform, over what outlines have drawn.
 * Fetches the code when the first ones do.
 */
export function drawMoving(
  outlines: DrawnOutlines,
  renderer: WebGLRenderer,
  scene: Scene,
  camera: Camera,
  fetch: FetchMoving = fetchOfWebGL,
): void {
  const intersections = sceneOf(topOf(outlines.mesh!));
  const { parts, root } = intersections;
  const code = codes.get(fetch);
  if (code) screenOf(renderer, code).draw(outlines, intersections.partOf(outlines), parts, root, scene, camera);
  else if (code === undefined && intersections.beginsToMove(renderer, camera)) fetchMoving(fetch, root).catch(() => {});
}

function screenOf(renderer: WebGLRenderer, code: MovingCode): ScreenLines {
  let screen = screens.get(renderer);
  if (!screen) {
    screen = new ScreenLines(renderer, code.makeDrawer(renderer));
    screens.set(renderer, screen);
  }
  return screen;
}

async function fetchMoving(fetch: FetchMoving, root: Object3D): Promise<void> {
  codes.set(fetch, null);
  try {
    codes.set(fetch, await fetch());
    root.dispatchEvent({ type: 'intersections' } as never);
  } catch (error) {
    codes.delete(fetch);
    throw error;
  }
}

/** Frees the lines of outlines. */
export function forgetIntersections(outlines: IntersectingOutlines): void {
  held.get(outlines)?.dispose();
  held.delete(outlines);
}

/** Computes the lines of intersection of all outlines below an object that want them, where they are now. */
export async function settleIntersections(root: Object3D, options: TaskOptions = {}): Promise<void> {
  const wanting: IntersectingOutlines[] = [];
  root.updateWorldMatrix(true, true);
  root.traverse((object) => {
    const outlines = object as Object3D & IntersectingOutlines;
    if ('isHatchingOutlines' in outlines && outlines.mesh && wantsIntersections(outlines)) wanting.push(outlines);
  });
  if (wanting.length === 0) return;
  const scene = sceneOf(topOf(root));
  for (const outlines of wanting) scene.note(outlines);
  await scene.update(options);
}
