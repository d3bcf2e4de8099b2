import type { BufferGeometry, Camera, Material, Mesh } from 'three';
import type { OutlineData } from '../geometry/OutlineData.js';
import type { ContourList } from './ContourList.js';
import type { InstanceList } from './InstanceList.js';
import { NO_PART, splitterOf } from './PrimitiveSplitter.js';
import { isShown, looksAlike, opacityOf, type SurfacePart, surfaceParts } from './surfaceRules.js';

/** The greatest number of lists, one per camera: more than the six cameras of a CubeCamera and two eyes. */
const MAX_LISTS = 12;

/** The list of each camera of primitives that may hold an outline. */
class CameraLists {
  private readonly lists = new Map<Camera, ContourList | InstanceList>();

  /** The list of a camera. If there are too many, the oldest is removed, since its camera may be gone. */
  of<List extends ContourList | InstanceList>(camera: Camera, Kind: new () => List): List {
    const known = this.lists.get(camera);
    if (known instanceof Kind) return known;
    known?.dispose();
    if (this.lists.size >= MAX_LISTS && known === undefined) {
      const [oldest] = this.lists;
      oldest[1].dispose();
      this.lists.delete(oldest[0]);
    }
    const list = new Kind();
    this.lists.set(camera, list);
    return list;
  }

  dispose(): void {
    for (const list of this.lists.values()) list.dispose();
    this.lists.clear();
  }
}

/** Outlines that are drawn in one draw. */
export interface OutlinePart {
  data: OutlineData;
  /** The material of the surface. */
  surface: Material;
  readonly lists: CameraLists;
  /** Whether the part was made in this frame. While a draw range moves, a list of the part would never be used. */
  isNew: boolean;
}

/** A part without a list: all its primitives are tested. */
export const unlistedPart = (data: OutlineData, surface: Material): OutlinePart => ({
  ...{ data, surface, lists: new CameraLists(), isNew: true },
});

/** A set of parts of the surface whose outlines look alike, and one material of theirs. */
interface Look {
  surface: Material;
  parts: SurfacePart[];
}

const NONE: readonly OutlinePart[] = [];

/**
 * Divides the outlines of a mesh as three.js divides the mesh: by groups and their materials, within the draw range, without invisible
 * materials. Materials whose outlines look alike share a part, so that nearly every mesh has one.
 */
export class OutlineParts {
  /** The whole mesh as one part. */
  private whole: OutlinePart[] = [];
  private split: OutlinePart[] = [];
  /** The data that was split, and the division. */
  private splitData: OutlineData | null = null;
  private splitBy = '';
  private readonly division = new Division();

  /** The parts of the outlines of a mesh. Allocates nothing while the mesh is divided as in the previous frame. */
  of(mesh: Mesh, data: OutlineData): readonly OutlinePart[] {
    const { material, geometry } = mesh;
    if (!Array.isArray(material) && (!material || !isShown(material, geometry))) return NONE;
    const surface = soleLook(mesh, data);
    if (surface) return this.asWhole(data, surface);
    return this.ofGroups(mesh, data);
  }

  dispose(): void {
    for (const { lists } of this.whole) lists.dispose();
    this.whole = [];
    this.dropSplit();
  }

  /** A separate function, because variables that a closure captures are allocated at every call of the enclosing function. */
  private ofGroups(mesh: Mesh, data: OutlineData): readonly OutlinePart[] {
    const { geometry } = mesh;
    if (this.splitData === data && this.division.isThatOf(mesh)) {
      for (let i = 0; i < this.split.length; i++) {
        this.split[i].surface = this.division.surfaces[i];
        this.split[i].isNew = false;
      }
      return this.split;
    }
    const looks = looksOf(
      surfaceParts(mesh).filter((part) => isShown(part.material, geometry)),
      geometry,
    );
    if (looks.length === 0) return NONE;
    if (looks.length === 1 && isAll(looks[0].parts, data)) return this.asWhole(data, looks[0].surface);
    this.division.note(mesh, looks);
    return this.asSplit(data, looks);
  }

  private asWhole(data: OutlineData, surface: Material): readonly OutlinePart[] {
    if (this.whole.length === 0) this.whole.push({ data, surface, lists: new CameraLists(), isNew: false });
    this.whole[0].data = data;
    this.whole[0].surface = surface;
    return this.whole;
  }

  private asSplit(data: OutlineData, looks: readonly Look[]): readonly OutlinePart[] {
    const splitBy = looks.map(({ parts }) => parts.map(({ start, end }) => `${start}-${end}`).join()).join(';');
    const isNew = this.splitData !== data || this.splitBy !== splitBy;
    if (isNew) {
      this.dropSplit();
      const found = splitterOf(data).split(triangleParts(looks, data.triangleCount), looks.length);
      this.split = found.map((of, i) => ({ data: of, surface: looks[i].surface, lists: new CameraLists(), isNew }));
      this.splitData = data;
      this.splitBy = splitBy;
    }
    for (let i = 0; i < looks.length; i++) Object.assign(this.split[i], { surface: looks[i].surface, isNew });
    return this.split;
  }

  private dropSplit(): void {
    for (const { data, lists } of this.split) {
      lists.dispose();
      data.primitives.dispose();
    }
    this.split = [];
    this.splitData = null;
    this.splitBy = '';
  }
}

/** The look of a group that is not drawn. */
const NO_LOOK = -1;
/** Numbers per group: its first corner, its number of corners, and its look. */
const NUMBERS_PER_GROUP = 3;

/** The division of a mesh into looks. */
class Division {
  /** The material of the first group of each look. */
  readonly surfaces: Material[] = [];
  private readonly firstGroups: number[] = [];
  private readonly groups: number[] = [];
  private start = 0;
  private count = 0;

  note(mesh: Mesh, looks: readonly Look[]): void {
    const { drawRange } = mesh.geometry;
    this.start = drawRange.start;
    this.count = drawRange.count;
    this.surfaces.length = this.groups.length = 0;
    this.surfaces.push(...looks.map(({ surface }) => surface));
    for (let i = 0; i < groupCount(mesh); i++) {
      const { start = 0, count = 0 } = mesh.geometry.groups[i] ?? {};
      const material = drawnMaterial(mesh, i);
      const look = this.surfaces.findIndex((surface) => material && looksAlike(surface, material, mesh.geometry));
      this.groups.push(start, count, look);
    }
    for (let look = 0; look < looks.length; look++) {
      const at = this.groups.findIndex((value, i) => i % NUMBERS_PER_GROUP === NUMBERS_PER_GROUP - 1 && value === look);
      this.firstGroups[look] = Math.floor(at / NUMBERS_PER_GROUP);
    }
  }

  /** Whether a mesh still has this division. Updates the materials; allocates nothing. */
  isThatOf(mesh: Mesh): boolean {
    const { groups, firstGroups, surfaces } = this;
    const { geometry } = mesh;
    const { drawRange } = geometry;
    const count = groupCount(mesh);
    if (groups.length !== NUMBERS_PER_GROUP * count || drawRange.start !== this.start || drawRange.count !== this.count)
      return false;
    for (let i = 0; i < count; i++) {
      const group = geometry.groups[i];
      if (group && (group.start !== groups[NUMBERS_PER_GROUP * i] || group.count !== groups[NUMBERS_PER_GROUP * i + 1]))
        return false;
      const material = drawnMaterial(mesh, i);
      const look = groups[NUMBERS_PER_GROUP * i + 2];
      if ((material === null) !== (look === NO_LOOK)) return false;
      if (material === null) continue;
      if (firstGroups[look] === i) surfaces[look] = material;
      else if (!looksAlike(surfaces[look], material, geometry)) return false;
    }
    return this.isInOrder(geometry);
  }

  /** Whether the looks still differ, and are still sorted with the most opaque first. */
  private isInOrder(geometry: BufferGeometry): boolean {
    const { firstGroups, surfaces } = this;
    for (let b = 1; b < surfaces.length; b++) {
      const fall = opacityOf(surfaces[b - 1], geometry) - opacityOf(surfaces[b], geometry);
      if (fall < 0 || (fall === 0 && firstGroups[b - 1] > firstGroups[b])) return false;
      for (let a = 0; a < b; a++) if (looksAlike(surfaces[a], surfaces[b], geometry)) return false;
    }
    return true;
  }
}

/** The number of groups of a mesh that may be drawn separately. */
const groupCount = ({ geometry, material }: Mesh): number => (Array.isArray(material) ? geometry.groups.length : 1);

/** The material that draws a group of a mesh; null if it is not drawn. */
function drawnMaterial({ geometry, material }: Mesh, group: number): Material | null {
  if (!Array.isArray(material)) return isShown(material, geometry) ? material : null;
  const { start, count, materialIndex = 0 } = geometry.groups[group];
  const { drawRange } = geometry;
  const own = material[materialIndex];
  const end = Math.min(start + count, drawRange.start + drawRange.count);
  return own && end - Math.max(start, drawRange.start) >= 3 && isShown(own, geometry) ? own : null;
}

/**
 * The first material of a mesh that is drawn whole and with one look, its groups in order if it has several materials; null in any
 * other case.
 */
function soleLook({ material, geometry }: Mesh, { triangleCount }: OutlineData): Material | null {
  const { groups, drawRange } = geometry;
  if (drawRange.start > 0 || drawRange.start + drawRange.count < 3 * triangleCount) return null;
  if (!Array.isArray(material)) return material;
  let surface: Material | null = null;
  let known = 0;
  for (const { start, count, materialIndex = 0 } of groups) {
    const own = material[materialIndex];
    if (!own || start > known || !isShown(own, geometry)) return null;
    surface ??= own;
    if (!looksAlike(surface, own, geometry)) return null;
    known = Math.max(known, start + count);
  }
  return known >= 3 * triangleCount ? surface : null;
}

/** Groups parts by their looks, the most opaque first: an edge between two looks has that of the first. */
function looksOf(parts: readonly SurfacePart[], geometry: BufferGeometry): Look[] {
  const looks: Look[] = [];
  for (const part of parts) {
    const known = looks.find(({ surface }) => looksAlike(surface, part.material, geometry));
    if (known) known.parts.push(part);
    else looks.push({ surface: part.material, parts: [part] });
  }
  return looks.sort((a, b) => opacityOf(b.surface, geometry) - opacityOf(a.surface, geometry));
}

const firstOf = ({ start }: SurfacePart): number => Math.ceil(start / 3);
const endOf = ({ end }: SurfacePart): number => Math.floor(end / 3);

/** Whether parts cover the whole mesh. */
function isAll(parts: readonly SurfacePart[], { triangleCount }: OutlineData): boolean {
  let known = 0;
  for (const part of [...parts].sort((a, b) => a.start - b.start))
    if (firstOf(part) <= known) known = Math.max(known, endOf(part));
  return known >= triangleCount;
}

/** The look of each triangle; if several parts contain it, that of the first. */
function triangleParts(looks: readonly { parts: readonly SurfacePart[] }[], triangleCount: number): Int32Array {
  const partOf = new Int32Array(triangleCount).fill(NO_PART);
  for (let i = looks.length - 1; i >= 0; i--)
    for (const part of looks[i].parts) partOf.fill(i, firstOf(part), Math.min(triangleCount, endOf(part)));
  return partOf;
}
