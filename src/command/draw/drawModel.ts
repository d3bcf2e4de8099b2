import { openAsBlob } from 'node:fs';
import { stat } from 'node:fs/promises';
import { totalmem } from 'node:os';
import { basename, dirname } from 'node:path';
import { Color, MathUtils, type Mesh } from 'three';
import type { HatchingMaterial } from 'three-hatching';
import { drawSVG, type SVGDrawing } from 'three-hatching/svg';
import { loadSimplifier, simplifierOf } from '../../mesh/detail/loadSimplifier.js';
import { buildModel } from '../../viewer/drawing/buildModel.js';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { meshesOf } from '../../viewer/drawing/meshes.js';
import { FILE_CHANGE_KINDS, type HowRead } from '../../viewer/files/common/fileChanges.js';
import { counted, indexOfName, ModelError, shownName } from '../../viewer/files/common/ModelError.js';
import { extensionOf, type ModelFile } from '../../viewer/files/common/ModelFile.js';
import { triangleCount } from '../../viewer/files/mesh/PlainMesh.js';
import { simplifyMesh } from '../../viewer/files/mesh/simplifyMesh.js';
import { withPictures } from '../../viewer/files/pictures/decodePictures.js';
import { missingDetail, missingNote } from '../../viewer/files/pictures/meshPictures.js';
import { type ReadMesh, type ReadModel, readModel } from '../../viewer/files/readModel.js';
import { lightsOfFile } from '../../viewer/sceneSetup/ofFile.js';
import { turnCamera } from '../../viewer/sceneSetup/placeCamera.js';
import { isReadAlike, type ModelChoice, NO_CHOICE, readLink } from '../../viewer/settings/shareLink.js';
import type { DrawingCounts, DrawMessage, DrawTask } from '../draw.js';
import type { DrawingOptions } from '../parseDrawing.js';
import { chooseParts } from './chooseParts.js';
import { plainSentence } from './failure.js';
import { NodeSurroundings } from './NodeSurroundings.js';
import { type ReadyScene, settingsFor, setUpScene } from './setUpScene.js';

/** Progress at the end of reading, of adjacency and of baking; drawing takes the rest. */
const READ = 0.08;
const JOINED = 0.25;
const BAKED = 0.5;

/** Steps in which progress is reported: a message for every slice of work would take a share of the time. */
const STEPS = 500;

/** At most this many missing things are named one by one. */
const NAMED = 12;

/**
 * Draws a model, with all its frames.
 *
 * @param say receives progress, notes and drawings
 * @returns whether the drawing is complete
 * @throws ModelError or Error, whose message is a sentence about the model
 */
export async function drawModel(
  { model: path, options, content }: DrawTask,
  say: (message: DrawMessage) => void,
  signal: AbortSignal = new AbortController().signal,
): Promise<boolean> {
  const name = basename(path);
  checkPens(options);
  let last = { stage: '', step: 0 };
  const progress = (stage: string, share: number): void => {
    const step = Math.floor(STEPS * share);
    if (stage === last.stage && step === last.step) return;
    last = { stage, step };
    say({ kind: 'progress', stage, progress: share });
  };
  const note = (sentence: string): void => say({ kind: 'note', sentence });
  const surroundings = new NodeSurroundings(dirname(path));
  const file = { name, content: await contentOf(path, content), format: options.format };
  const asked = choiceOf(options.link);
  let read = await readFrom(file, surroundings, howToRead(options, asked), say);
  // An archive saved by the playground contains the look along with the model.
  const link = options.link ?? read.drawing?.link;
  const linked = choiceOf(link);
  if (!isReadAlike(howToRead(options, linked), howToRead(options, asked)))
    read = await readFrom(file, surroundings, howToRead(options, linked), say);
  const report = (stage: string, share = 0): void => progress(stage, READ + (JOINED - READ) * share);
  const { model, notes } = await buildModel(read, report, signal, false, (names) =>
    chooseParts(names, options, linked.hidden ?? [], name),
  );
  if (!model.parts && options.hide.length + options.only.length > 0)
    throw new ModelError(`${name} has only one part, so --hide and --only have nothing to choose from.`);
  if (options.pens === 'part' && model.joinedParts)
    note(`${name}: its parts are read as one mesh, so they share the layers of --pens part.`);
  tellFaults(name, read, notes, note);
  const drawnWith = settingsFor(options, link, model.stands ?? read.upAxis);
  chooseClip(model, options, linked, name);
  checkChosen(model, options, name);
  for (const offer of offersOf(model, options, linked)) note(`${name} ${offer}.`);
  const angles = anglesOf(options);
  const staged = await setUpScene(model, drawnWith, options, angles, {
    signal,
    report: (stage, share) => progress(stage, JOINED + (BAKED - JOINED) * share),
  });
  const isWhole = tellPictures(name, model, read, surroundings, note);
  await drawFrames(model, staged, options, name, { say, progress, note, signal });
  return isWhole;
}

/** @throws ModelError if a pen has no colour */
function checkPens({ pens }: DrawingOptions): void {
  if (typeof pens !== 'object') return;
  for (const { color } of pens)
    if (!/^#/.test(String(color)) && !Object.hasOwn(Color.NAMES, String(color)))
      throw new ModelError(`--pens has the colour ${color}, which is not a colour of CSS, such as navy or #d33.`);
}

async function contentOf(path: string, content: Uint8Array | undefined): Promise<Blob> {
  if (content) return new Blob([content as Uint8Array<ArrayBuffer>]);
  if (!(await stat(path)).isFile()) throw new ModelError(`${path} is no file.`);
  return openAsBlob(path);
}

async function readFrom(
  file: ModelFile,
  surroundings: NodeSurroundings,
  how: HowRead,
  say: (message: DrawMessage) => void,
): Promise<ReadModel> {
  const onStage = (stage: string, bytes?: number): void =>
    say({ kind: 'progress', stage, bytes, progress: 0.5 * READ });
  const read = await readModel([file], onStage, surroundings, how);
  if (read.kind !== 'mesh') return withPictures(read, onStage, surroundings);
  const onProgress = (share: number): void =>
    say({ kind: 'progress', stage: 'simplifying', progress: READ * (0.5 + 0.5 * share) });
  return withPictures(await fitMemory(read, mostTriangles(memoryHere()), onProgress), onStage, surroundings);
}

/** How the file is read, by the options and the link. */
function howToRead({ variant, asWritten, bothSides }: DrawingOptions, linked: ModelChoice): HowRead {
  const kinds = new Set([...asWritten, ...(bothSides ? ['sides'] : []), ...(linked.switched ?? [])]);
  return {
    variant: variant ?? linked.variant,
    switched: FILE_CHANGE_KINDS.filter((kind) => kinds.has(kind)),
  };
}

const choiceOf = (link: string | undefined): ModelChoice => (link === undefined ? NO_CHOICE : readLink(link).choice);

/** The angles of the camera for the frames, in radians; all 0 where a clip moves the model instead. */
function anglesOf({ frames = 1, clip }: DrawingOptions): number[] {
  return Array.from({ length: clip === undefined ? frames : 1 }, (_, i) => MathUtils.degToRad((360 * i) / frames));
}

function chooseClip({ motion }: HatchedModel, { clip }: DrawingOptions, linked: ModelChoice, name: string): void {
  if (clip === undefined) {
    // The link may name a clip that the file lacks; Motion then takes the first.
    if (motion && linked.clip !== undefined) motion.clip = linked.clip;
    return;
  }
  const clips = motion?.clips ?? [];
  const index = indexOfName(clips, clip);
  if (!motion || clips.length === 0) throw new ModelError(`${name} has no clips.`);
  if (index === -1) throw new ModelError(`${name} has no clip ${clip}; it has ${clips.join(', ')}.`);
  motion.clip = index;
}

/** @throws ModelError if the model has no such camera, or no variants. The glTF reader has already refused an unknown variant */
function checkChosen({ extras }: HatchedModel, { camera, variant }: DrawingOptions, name: string): void {
  if (variant !== undefined && extras.variants.length === 0)
    throw new ModelError(`${name} has no variants of its materials.`);
  if (camera === undefined) return;
  const names = extras.cameras.map((one) => one.name);
  if (names.length === 0) throw new ModelError(`${name} has no cameras.`);
  if (indexOfName(names, camera) === -1)
    throw new ModelError(`${name} has no camera ${camera}; it has ${names.join(', ')}.`);
}

/** Sentences about cameras, lights, variants and clips of the model that no option selects. */
function offersOf(
  { extras, motion }: HatchedModel,
  { camera, variant, clip, ...options }: DrawingOptions,
  linked: ModelChoice,
): string[] {
  const { cameras, variants, lights } = extras;
  const clips = motion?.clips ?? [];
  const leftOut = options.usesFileLights && !options.light ? (lightsOfFile(lights)?.leftOut ?? 0) : 0;
  return [
    ...offer(
      'camera',
      cameras.map((one) => one.name),
      // The automatic view is that of the first.
      camera ?? (cameras.length === 1 && !options.view && !options.link ? 0 : undefined),
    ),
    ...offer('variant', variants, variant ?? linked.variant),
    ...(clips.length > 1 ? offer('clip', clips, clip ?? linked.clip) : []),
    ...(leftOut > 0
      ? [
          `has ${counted(leftOut, 'light', `that ${leftOut === 1 ? 'is' : 'are'} not drawn: the brightest two are, at most`)}`,
        ]
      : []),
  ];
}

/** A sentence that names the choices, if there are any and none was made. */
function offer(option: string, names: readonly string[], chosen: string | number | undefined): string[] {
  if (chosen !== undefined || names.length === 0) return [];
  const list = names.length > NAMED ? [...names.slice(0, NAMED), '…'] : names;
  const [plural, one] = names.length === 1 ? ['', 'it'] : ['s', 'one'];
  return [`has the ${option}${plural} ${list.join(', ')}: --${option} draws with ${one}`];
}

/** Reports what is wrong with the model: one line per missing file. */
function tellFaults(
  name: string,
  { missing, details, changes }: ReadModel,
  notes: readonly string[],
  note: (sentence: string) => void,
): void {
  const files = new Set(missing);
  for (const file of files) note(`${name}: ${shownName(file)} is missing; put it beside the model.`);
  const ofFiles = [...missingNote(missing), ...missingDetail(missing)];
  // The usual up axis of a format is no fault of the file.
  const changed = changes.filter(({ kind }) => kind !== 'up').map(({ sentence }) => sentence);
  for (const one of [...notes, ...details, ...changed])
    if (!ofFiles.includes(one)) note(`${name}: ${plainSentence(one)}.`);
}

/**
 * Reports which pictures were left out because they cannot be decoded here.
 *
 * @returns whether no picture is missing that the drawing would show
 * @throws ModelError if a missing picture cuts out surfaces: leaves, for instance, would be drawn as whole sheets
 */
function tellPictures(
  name: string,
  model: HatchedModel,
  { missing, lostPictures = 0 }: ReadModel,
  { undecoded }: NodeSurroundings,
  note: (sentence: string) => void,
): boolean {
  const materials = meshesOf(model.root).flatMap(({ material }: Mesh) => material as HatchingMaterial);
  const formats = [...undecoded].join(' and ');
  if (formats !== '' && materials.some(({ alphaTest, map }) => alphaTest > 0 && map && !map.image))
    throw new ModelError(
      `${name} has surfaces that are cut out by pictures in ${formats}, which are not read here; save them as PNG.`,
    );
  materials.forEach(dropEmptyPictures);
  const showsColours = materials.some(({ colorHatching, colorFill }) => colorHatching > 0 || colorFill > 0);
  if (!showsColours) return true;
  if (formats !== '')
    note(`${name} is drawn without its pictures in ${formats}, which are not read here; save them as PNG.`);
  const isMissing = missing.some((file) => extensionOf(file) !== 'mtl');
  return formats === '' && !isMissing && lostPictures === 0;
}

const PICTURES = ['map', 'emissiveMap', 'aoMap', 'lightMap', 'alphaMap', 'normalMap', 'bumpMap'] as const;

/** Removes missing pictures from a material. They were reported once; each mesh would report them again. */
function dropEmptyPictures(material: HatchingMaterial): void {
  for (const name of PICTURES) if (material[name] && !material[name].image) material[name] = null;
}

async function drawFrames(
  { motion }: HatchedModel,
  { scene, placed, placeLights, sheet }: ReadyScene,
  { frames = 1, clip, ...options }: DrawingOptions,
  name: string,
  to: {
    say: (message: DrawMessage) => void;
    progress: (stage: string, share: number) => void;
    note: (sentence: string) => void;
    signal: AbortSignal;
  },
): Promise<void> {
  const { kind, pen, pens, refill, isSplit, written, lines, shortest, maxPasses, margin, dpi, ...others } = options;
  const { paper, order, hidden, animate, note, preset } = others;
  const told = new Set<string>();
  let before: SVGDrawing | null = null;
  for (let frame = 0; frame < frames; frame++) {
    if (motion && clip !== undefined) motion.time = (frame / frames) * motion.duration;
    else if (frame > 0) turnCamera(placed, (2 * Math.PI) / frames);
    scene.updateMatrixWorld();
    placeLights();
    const stage = frames === 1 ? 'drawing' : `drawing frame ${frame + 1} of ${frames}`;
    const drawing: SVGDrawing = await drawSVG(scene, placed.camera, {
      ...{ kind, sheet, margin, dpi, order, hidden, animate },
      ...(kind === 'pen' && {
        penWidth: pen,
        pens,
        refill,
        lines: lines ?? 'even',
        before: frames > 1 ? before : undefined,
        ...{ shortest, maxPasses },
        dxf: written === 'dxf',
        note: note && (preset === undefined ? name : `${name}, ${preset}`),
      }),
      ...(isSplit && { split: 'pen' }),
      ...(paper !== undefined && { paper }),
      signal: to.signal,
      onProgress: (share) => to.progress(stage, BAKED + (1 - BAKED) * ((frame + share) / frames)),
    });
    before = drawing;
    const { svg, files, dxf, leftOut, ...counts } = drawing;
    const reasons = leftOut.map(({ reason }) => reason);
    if (counts.paths === 0) throw new ModelError(`${name} has no lines in this view. ${reasons[0] ?? ''}`.trim());
    const fresh = reasons.filter((reason) => !told.has(reason));
    for (const reason of fresh) told.add(reason);
    for (const reason of fresh.slice(0, NAMED)) to.note(`${name}: ${reason}`);
    if (fresh.length > NAMED) to.note(`${name}: the same applies to ${fresh.length - NAMED} more.`);
    const texts = isSplit
      ? files.map(({ name, svg: text }, i) => ({ ending: `${i + 1}-${plainName(name)}`, text }))
      : [{ ending: '', text: dxf ?? svg }];
    to.say({ kind: 'drawing', frame, texts, counts: countsOf(counts) });
  }
}

const countsOf = ({ paths, drawn, travelBefore, travelAfter, plotSeconds, layers }: DrawingCounts): DrawingCounts => ({
  ...{ paths, drawn, travelBefore, travelAfter, plotSeconds },
  layers: layers.map(({ name, paths, drawn, plotSeconds }) => ({ name, paths, drawn, plotSeconds })),
});

/** A name of a layer as part of a file's name. */
const plainName = (name: string): string => name.replaceAll(/[^\p{L}\p{N}.#_-]+/gu, '-').slice(0, 60);

/**
 * Bytes per triangle until its lines are written, with form lines and dark hollows. Measured on scans of one and of three million
 * triangles.
 */
const BYTES_PER_TRIANGLE = 1300;
/** The share of the memory that a model may use. */
const SHARE = 0.75;
/** The module of meshoptimizer's simplifier, an optional peer dependency. */
const SIMPLIFIER = 'meshoptimizer/simplifier';

/** The number of triangles that can be drawn, rounded down. @param bytes of memory */
export const mostTriangles = (bytes: number): number => Math.floor((SHARE * bytes) / BYTES_PER_TRIANGLE / 1e5) * 1e5;

/** The bytes of memory available to this process: the machine's, or its container's limit. */
export function memoryHere(): number {
  // Node 18 does not know limits of containers, and other versions return 0 where there is none.
  return Math.min(totalmem(), process.constrainedMemory?.() || Infinity);
}

/**
 * Simplifies a model that has more triangles than `most`, and adds a note that says so.
 *
 * @param onProgress called with rising numbers in [0, 1]
 * @param simplifier the module of meshoptimizer's simplifier
 * @throws ModelError if it has too many triangles and cannot be simplified
 */
export async function fitMemory(
  model: ReadMesh,
  most: number,
  onProgress: (progress: number) => void,
  simplifier = SIMPLIFIER,
): Promise<ReadMesh> {
  const triangles = triangleCount(model.mesh);
  if (triangles <= most) return model;
  const [all, enough] = [triangles, most].map((count) => count.toLocaleString('en'));
  const tooLarge = `It has ${all} triangles, and the memory here is enough for ${enough}.`;
  if (model.mesh.uvs) throw new ModelError(`${tooLarge} Models with pictures are not simplified.`);
  try {
    await loadSimplifier(simplifier);
  } catch {
    throw new ModelError(
      `${tooLarge} With meshoptimizer beside three-hatching it is simplified: npm install meshoptimizer.`,
    );
  }
  const { mesh, error } = simplifyMesh(model.mesh, simplifierOf(simplifier), onProgress, most);
  const [drawn, share] = [triangleCount(mesh).toLocaleString('en'), (100 * error).toFixed(2)];
  return {
    ...model,
    mesh,
    simplified: { triangles, error },
    notes: [
      ...model.notes,
      `${drawn} of ${all} triangles are drawn, for which there is memory: within ${share} % of the radius from all of them`,
    ],
  };
}
