import { Matrix4, type Mesh, type MeshPhongMaterial, type Object3D } from 'three';
import { isSeenFromBehind } from '../../mesh/orientation/seenFromBehind.js';
import { runToEnd } from '../../mesh/phases.js';
import type { ChosenView } from '../views/chooseViews.js';
import type { BundledDrawing } from './bundle.js';
import { toUtf8 } from './common/AsciiReader.js';
import type { FileChange, FileChangeKind, HowRead } from './common/fileChanges.js';
import { counted, ModelError, shownName, toModelError } from './common/ModelError.js';
import { type ModelExtras, movedExtras } from './common/ModelExtras.js';
import { baseName, extensionOf, MAX_BYTES, type ModelFile, withoutGz } from './common/ModelFile.js';
import { BITMAPS, type FindFile, type Surroundings } from './common/Surroundings.js';
import { type OnStage, runStage } from './common/stages.js';
import {
  COMPANION_EXTENSIONS,
  FORMATS,
  type FormatFile,
  MODEL_EXTENSIONS,
  type ModelFormat,
  sniffFormat,
} from './formats.js';
import { type GltfParts, parseGltf } from './gltf/parseGltf.js';
import type { ReadGltf } from './gltf/readGltf.js';
import { withCastingSides } from './mesh/castingSides.js';
import { cleanMesh } from './mesh/cleanMesh.js';
import { dropDuplicates } from './mesh/dropDuplicates.js';
import { findUpAxis, type UsualUp, upOnMap } from './mesh/findUpAxis.js';
import { fitModel } from './mesh/fitModel.js';
import { hasWrongNormals } from './mesh/hasWrongNormals.js';
import { openCeiling } from './mesh/openCeiling.js';
import { orientMesh } from './mesh/orientMesh.js';
import { type NotedMesh, type PlainMesh, thinNote } from './mesh/PlainMesh.js';
import { hidesBacks, plainNormals } from './mesh/plainNormals.js';
import type { UpAxis } from './mesh/UpAxis.js';
import {
  type MeshPicture,
  missingDetail,
  missingNote,
  readMeshPictures,
  type WantedPicture,
} from './pictures/meshPictures.js';
import { gunzip, readArchive } from './readArchive.js';
import { DISPLACEMENT_NOTE, type LoadedScene } from './scenes/LoadedScene.js';
import { mergeScene } from './scenes/mergeScene.js';
import { findSceneCeiling } from './scenes/sceneCeiling.js';

export type { ModelFile, OnStage };

/** A model that was read: one mesh, or the checked parts of a file that must stay a scene. */
export type ReadModel = ReadMesh | ReadParts;

interface Read {
  /** The name of the main file. */
  name: string;
  /** The up axis: that of the feet, flat side or underside on which the model clearly stands, or else the usual one of the format. */
  upAxis: UpAxis;
  /** Notes for the caption: what is missing, chosen or left out, and why. The most important comes first. */
  notes: string[];
  /** Details for the longer text that opens on request. */
  details: string[];
  /** Changes that were made to what the file says. */
  changes: FileChange[];
  /** Names of files that were not dropped along. */
  missing: string[];
  /** The number of pictures that could not be read. */
  lostPictures?: number | undefined;
  /** The files of the archive, with those dropped along. Undefined without an archive. */
  unpacked?: readonly ModelFile[];
  /** The look of the drawing, if the archive is a bundle. */
  drawing?: BundledDrawing | undefined;
  /** Cameras, lights and variants, in the space of the mesh or of the unscaled parts. */
  extras?: ModelExtras | undefined;
}

export interface ReadMesh extends Read {
  kind: 'mesh';
  mesh: PlainMesh;
  /** The pictures of the mesh's ranges; undefined for missing ones. */
  pictures: (MeshPicture | undefined)[];
  /** Normals for a placeholder that is drawn until the mesh is baked; null if none is needed, or a coarse copy is the placeholder. */
  plainNormals: Float32Array | null;
  /** Whether the back faces of the placeholder are hidden. False without `plainNormals`. */
  hidesBacks: boolean;
  /** The up axis by what the model stands on, if that differs from the format's usual one. */
  stands: UpAxis | undefined;
  /** The result of simplification: the number of triangles in the file, and the maximum deviation in radii. Undefined if not simplified. */
  simplified?: { triangles: number; error: number } | undefined;
  /** The views that show it best, if they were asked for. */
  views?: readonly ChosenView[] | undefined;
  /** Precomputed ambient occlusion, as `writeOcclusion` of src/viewer/drawing takes it. */
  occlusion?: Uint8Array<ArrayBuffer> | undefined;
}

export interface ReadParts extends Read {
  kind: 'parts';
  /** The usual orientation of the format, for finding the up axis; undefined if the file states it. */
  usual: UsualUp | undefined;
  parts: GltfParts;
}

/**
 * Reads a model from one or several files: unpacks, detects the format, checks the header, parses, merges, removes broken triangles and
 * fits the rest into a unit sphere. A glTF file that stays a scene is only checked and split into its parts.
 *
 * @param surroundings decoders of pictures and Draco; by default those of a browser, without Draco
 * @param how the variant, and the kinds of changes that are switched from what is usual
 * @throws ModelError with one sentence for the user
 */
export async function readModel(
  files: readonly ModelFile[],
  onStage: OnStage,
  surroundings: Surroundings = BITMAPS,
  { variant, switched = [] }: HowRead = {},
): Promise<ReadModel> {
  const size = files.reduce((sum, file) => sum + file.content.size, 0);
  if (size > MAX_BYTES) {
    throw new ModelError(
      `The files have ${Math.round(size / 2 ** 20)} MB together; this page takes up to ${MAX_BYTES / 2 ** 20} MB.`,
    );
  }
  const main = chooseMain(files);
  onStage(`reading ${shownName(main.name)}`);
  try {
    const read = await readMain(main, files, onStage, { ...surroundings, variant, switched });
    return { ...read, notes: [...read.notes, ...otherModelsNote(main, files)] };
  } catch (error) {
    throw toModelError(main.name, error);
  }
}

/** The options and platform functions of one reading. */
interface Circumstances extends Surroundings {
  variant: string | number | undefined;
  switched: readonly FileChangeKind[];
}

async function readMain(
  main: ModelFile,
  files: readonly ModelFile[],
  onStage: OnStage,
  surroundings: Circumstances,
  isUnpacked = false,
): Promise<ReadModel> {
  const { loadDraco, decodePicture, variant, switched } = surroundings;
  const name = withoutGz(main.name);
  const shown = shownName(main.name);
  const bytes = toUtf8(await gunzip(new Uint8Array(await main.content.arrayBuffer()), shown, MAX_BYTES));
  onStage(`reading ${shown}`, bytes.length);
  let format = sniffFormat(withoutGz(shown), bytes, main.format);
  if (format === 'zip') {
    const archive = await readArchive(bytes, shown, {
      formats: FORMATS,
      modelExtensions: MODEL_EXTENSIONS,
      companionExtensions: COMPANION_EXTENSIONS,
    });
    if ('files' in archive) {
      // An archive could contain itself.
      if (isUnpacked) throw new ModelError(`${shown} is an archive in an archive, which this page does not unpack.`);
      const along = files.filter((file) => file !== main);
      return { ...(await readArchived(archive.files, name, along, onStage, surroundings)), drawing: archive.drawing };
    }
    ({ format } = archive);
  }
  const findFile = finderIn(files, surroundings);
  const file = { bytes, name: shown, findFile, loadDraco, variant, switched };
  const isTurned = !format.isWindingCertain && !switched.includes('orientation');
  const { content, extras, turned: turnedParts, ...parsed } = await parse(format, file, isTurned);
  const orientation = orientationOf(format, switched);
  const { usual, upAxis, upChanges } = orientation;
  const ofReader = parsed.changes ?? [];
  if ('arrays' in content) {
    const { missing, lostPictures } = parsed;
    const notes = [...missingNote(missing), ...parsed.notes];
    const other = otherFormatNote(main, format);
    const details = [...missingDetail(missing), ...other, ...brokenNote(parsed.broken), ...parsed.details];
    const { parts, changes: sides } = await openedParts(content, orientation, switched);
    return {
      kind: 'parts',
      ...{ name, upAxis, usual, notes, details, missing, lostPictures, extras, parts },
      changes: [...upChanges, ...ofReader, ...turnedChange(turnedParts), ...sides],
    };
  }
  onStage('looking over the triangles');
  const { merged, toMesh, wanted } = mergedOf(content, parsed.notes);
  const { mesh: distinct, duplicates } = dropDuplicates(merged, !isTurned);
  const { mesh: whole, broken } = cleanMesh(distinct);
  const { mesh: oriented, changes: faced } = isTurned ? facingRight(whole, onStage) : { mesh: whole, changes: [] };
  onStage('looking for the ground');
  const { stands, up, stood } = standingOf(oriented, toMesh, orientation);
  const { mesh, isOpened } = withoutCeiling(oriented, up, switched);
  const { centre, radius } = fitModel(mesh);
  const normals = plainNormals(mesh);
  const { pictures, clear, notes, lostPictures, ...lacks } = await readMeshPictures(
    wanted,
    findFile,
    decodePicture,
    (number, count) => onStage(`decoding picture ${number} of ${count}`),
  );
  const missing = [...parsed.missing, ...lacks.missing];
  return {
    kind: 'mesh',
    name,
    upAxis: up,
    stands,
    mesh: withCastingSides(withClearRanges(mesh, clear)),
    pictures,
    plainNormals: normals,
    hidesBacks: normals !== null && hidesBacks(mesh),
    extras: extras && movedExtras(extras, fitOf(centre, radius)),
    missing,
    lostPictures: (parsed.lostPictures ?? 0) + lostPictures,
    notes: [...missingNote(missing), ...thinNote(mesh.positions, mesh.indices), ...parsed.notes, ...notes],
    details: [
      ...missingDetail(missing),
      ...otherFormatNote(main, format),
      ...brokenNote(parsed.broken + broken),
      ...duplicateNote(duplicates),
      ...behindNote(mesh),
      ...parsed.details,
    ],
    changes: [
      ...stood,
      ...ofReader,
      ...faced,
      ...sidesChange(switched.includes('sides') && format.isSideCertain === true),
      ...ceilingChange(isOpened),
    ],
  };
}

/** The mesh of a format's content, the matrix from its space, and the pictures that it wants. */
function mergedOf(
  content: PlainMesh | Object3D,
  notes: string[],
): { merged: PlainMesh; toMesh: Matrix4; wanted: WantedPicture[] } {
  const wanted: WantedPicture[] = [];
  const toMesh = new Matrix4();
  const merged = 'isObject3D' in content ? mergeScene(content, wanted, toMesh, notes) : content;
  return { merged, toMesh, wanted };
}

/** Finds files by the URIs of others. */
function finderIn(files: readonly ModelFile[], surroundings: Surroundings): FindFile {
  return async (uri) => {
    const wanted = comparedName(safeDecode(uri));
    const file = files.find((one) => comparedName(one.name) === wanted);
    return file ? new Uint8Array(await file.content.arrayBuffer()) : surroundings.findFile?.(uri);
  };
}

/** Marks the ranges with see-through pictures as glass, and removes those pictures. */
function withClearRanges(mesh: PlainMesh, clear: ReadonlySet<number>): PlainMesh {
  if (clear.size === 0) return mesh;
  const ranges = mesh.ranges?.map((range) =>
    clear.has(range.picture) ? { ...range, picture: -1, isSeeThrough: true } : range,
  );
  return { ...mesh, ...(ranges && { ranges }) };
}

/** The matrix that moves a centre to the origin and scales a radius to 1. */
const fitOf = ([x, y, z]: readonly [number, number, number], radius: number): Matrix4 =>
  new Matrix4().makeScale(1 / radius, 1 / radius, 1 / radius).multiply(new Matrix4().makeTranslation(-x, -y, -z));

/** Reads the model in an archive with the files `archived`, together with those dropped along. */
async function readArchived(
  archived: readonly ModelFile[],
  name: string,
  dropped: readonly ModelFile[],
  onStage: OnStage,
  surroundings: Circumstances,
): Promise<ReadModel> {
  const main = chooseMain(archived);
  onStage(`reading ${shownName(main.name)}`);
  const unpacked = [...archived, ...dropped];
  const read = { ...(await readMain(main, unpacked, onStage, surroundings, true)), unpacked };
  const count = archived.filter((file) => rankOf(file) < MODEL_EXTENSIONS.length).length;
  return count === 1 ? read : { ...read, notes: [`one of ${count} models in ${shownName(name)}`, ...read.notes] };
}

/** A note that a file is not of the format given for it. A ZIP archive is judged by its content. */
function otherFormatNote({ format: said }: ModelFile, { name, extensions }: ModelFormat): string[] {
  if (said === undefined || said === 'zip' || extensions.includes(said)) return [];
  return [`read as ${name}, which its content is, and not as ${said.toUpperCase()}`];
}

/** A note that several models were dropped, of which one is shown. */
function otherModelsNote(main: ModelFile, files: readonly ModelFile[]): string[] {
  const others = files.filter((file) => file !== main && rankOf(file) < MODEL_EXTENSIONS.length);
  if (others.length === 0) return [];
  const which = others.length === 1 ? shownName(others[0].name) : 'another';
  return [`one of ${others.length + 1} models: drop ${which} by itself to see it`];
}

const brokenNote = (triangles: number): string[] =>
  triangles === 0 ? [] : [counted(triangles, 'triangle', 'without three valid corners left out')];

const duplicateNote = (triangles: number): string[] =>
  triangles === 0 ? [] : [counted(triangles, 'duplicate triangle', 'left out')];

/** A detail on a one-sided mesh that shows mostly its inside. */
const behindNote = ({ positions, indices, isOneSided }: PlainMesh): string[] =>
  isOneSided &&
  indices &&
  runToEnd(
    isSeenFromBehind({
      positions: positions as Float32Array<ArrayBuffer>,
      indices: indices as Uint32Array<ArrayBuffer>,
    }),
  )
    ? ['its surfaces have one side, as the file says, and are seen through from outside']
    : [];

const turnedChange = (triangles: number): FileChange[] =>
  triangles === 0
    ? []
    : [{ kind: 'orientation', sentence: `${counted(triangles, 'triangle', 'that faced inward')} turned around` }];

/** Turns the triangles that face the wrong way, and leaves out normals that contradict the triangles. */
function facingRight(mesh: PlainMesh, onStage: OnStage): { mesh: PlainMesh; changes: FileChange[] } {
  const { mesh: oriented, turned } = orientMesh(mesh, (task) =>
    runStage('looking for triangles that face inward', onStage, task),
  );
  const changes = turnedChange(turned);
  if (!hasWrongNormals(oriented)) return { mesh: oriented, changes };
  const sentence = 'normals that contradict its surfaces computed again';
  return { mesh: { ...oriented, normals: null }, changes: [...changes, { kind: 'orientation', sentence }] };
}

const sidesChange = (hasBothSides: boolean): FileChange[] =>
  hasBothSides ? [{ kind: 'sides', sentence: 'surfaces are drawn from both sides, also one-sided ones' }] : [];

/** Opens closed rooms, unless that is switched off. */
function withoutCeiling(
  mesh: PlainMesh,
  up: UpAxis,
  switched: readonly FileChangeKind[],
): { mesh: PlainMesh; isOpened: boolean } {
  const open = switched.includes('ceiling') ? undefined : openCeiling(mesh, up);
  return { mesh: open ?? mesh, isOpened: open !== undefined };
}

/**
 * Leaves out the ceiling of closed rooms, whose walls are drawn from both sides then, unless that is switched off, the parts move, or their up
 * axis is not certain.
 */
async function openedParts(
  parts: GltfParts,
  { usual }: Orientation,
  switched: readonly FileChangeKind[],
): Promise<{ parts: GltfParts; changes: FileChange[] }> {
  const changes = sidesChange(switched.includes('sides') && parts.hasBothSides);
  const { animations } = parts.json as { animations?: readonly unknown[] };
  if (usual || switched.includes('ceiling') || animations?.length) return { parts, changes };
  const ceiling = findSceneCeiling((await parseGltf(parts)).root);
  if (!ceiling) return { parts, changes };
  return { parts: { ...parts, ceiling, hasBothSides: true }, changes: [...changes, ...ceilingChange(true)] };
}

const ceilingChange = (isOpened: boolean): FileChange[] =>
  isOpened ? [{ kind: 'ceiling', sentence: 'its rooms are seen from above, without their ceiling' }] : [];

/** The usual orientation of a format; undefined where files state it. */
const usualUp = ({ up, isUpCertain, liesFlat = false }: ModelFormat): UsualUp | undefined =>
  isUpCertain ? undefined : { up, liesFlat };

/** The change of a model whose format has another up axis than the page. */
const upChange = ({ name, up, isUpCertain }: ModelFormat): FileChange[] =>
  up === 'z' && !isUpCertain ? [{ kind: 'up', sentence: `stood up: z is up in ${name} files` }] : [];

/** How the models of a format stand, and the change for it. */
interface Orientation {
  usual: UsualUp | undefined;
  upAxis: 'y' | 'z';
  upChanges: FileChange[];
}

/** How the models of a format stand; as written, y is up. */
function orientationOf(format: ModelFormat, switched: readonly FileChangeKind[]): Orientation {
  if (switched.includes('up')) return { usual: undefined, upAxis: 'y', upChanges: [] };
  return { usual: usualUp(format), upAxis: format.up, upChanges: upChange(format) };
}

/**
 * The up axis of a mesh, and the change for it: that of map coordinates, or of what it stands on, or the usual one of the format.
 *
 * @param toMesh the matrix from the space of the file
 */
function standingOf(
  { positions, indices }: PlainMesh,
  toMesh: Matrix4,
  { usual, upAxis, upChanges }: Orientation,
): { stands?: UpAxis | undefined; up: UpAxis; stood: FileChange[] } {
  const onMap = usual && upOnMap(toMesh.elements.slice(12, 15));
  const standing = onMap ? undefined : usual && findUpAxis(positions, indices, usual);
  const stands = onMap ?? standing?.up;
  if (!stands || onMap === upAxis) return { up: upAxis, stood: upChanges };
  const how = standing ? `on its ${standing.on}` : 'up as on maps';
  return { stands, up: stands, stood: [{ kind: 'up', sentence: `stood ${how}: ${stands} is up` }] };
}

/** The result of a format's reader. */
interface Parsed extends Omit<ReadGltf, 'content'> {
  content: PlainMesh | GltfParts | Object3D;
  /** The number of triangles that were turned because they faced inward. */
  turned: number;
}

/** @param turns whether triangles of a scene that stays one are turned */
async function parse(format: ModelFormat, file: FormatFile, turns: boolean): Promise<Parsed> {
  const read = await format.read(file);
  if ('content' in read) return { ...read, turned: 0 };
  if (!('root' in read) || read.root.animations.length === 0) return parsedOf(read);
  const notes = notesOn(read);
  const { readMoving } = await import('./scenes/readMoving.js');
  const { moving, turned } = await readMoving(read.root, file.name, file.findFile, turns);
  if (moving) {
    return { ...moving, turned, notes: [...new Set([...moving.notes, ...notes])], changes: read.changes ?? [] };
  }
  return parsedOf({ ...read, notes: ['shown without its motion'] });
}

/** Fills in a reader's missing fields: nothing missing, no notes. */
function parsedOf(read: NotedMesh | LoadedScene): Parsed {
  const isScene = 'root' in read;
  const { missing = [] }: Partial<LoadedScene> = isScene ? read : {};
  const content = isScene ? read.root : read.mesh;
  const changes = isScene ? (read.changes ?? []) : [];
  return { content, broken: 0, turned: 0, notes: isScene ? notesOn(read) : read.notes, details: [], changes, missing };
}

/** Notes for the caption on a scene: the reader's, and those on objects that are not drawn. */
function notesOn({ root, notes = [] }: LoadedScene): string[] {
  const all = new Set(notes);
  root.traverseVisible((object) => {
    const { isMesh, material } = object as Partial<Mesh>;
    if ('isLine' in object || 'isPoints' in object) all.add('points and lines left out');
    if (isMesh && [material ?? []].flat().some((one) => (one as MeshPhongMaterial).displacementMap))
      all.add(DISPLACEMENT_NOTE);
  });
  return [...all];
}

/** A file name for comparison, with blanks collapsed, as some readers do. */
const comparedName = (path: string): string => baseName(path).toLowerCase().replace(/\s+/g, ' ');

function safeDecode(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

function chooseMain(files: readonly ModelFile[]): ModelFile {
  const [main] = [...files].sort((a, b) => rankOf(a) - rankOf(b));
  if (!main) throw new ModelError('No file was dropped.');
  return main;
}

/** The rank of a file's extension in the order of preference; files that are no models come last. */
function rankOf({ name }: ModelFile): number {
  const at = MODEL_EXTENSIONS.indexOf(extensionOf(withoutGz(name)) ?? '');
  return at === -1 ? MODEL_EXTENSIONS.length : at;
}
