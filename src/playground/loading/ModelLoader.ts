import { HatchingMaterial } from 'three-hatching';
import { type BuiltInScene, buildModel } from '../../viewer/drawing/buildModel.js';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { isOpen } from '../../viewer/drawing/statistics.js';
import type { BundledDrawing } from '../../viewer/files/bundle.js';
import type { FileChange, FileChangeKind } from '../../viewer/files/common/fileChanges.js';
import { shownName } from '../../viewer/files/common/ModelError.js';
import type { ModelFile, ReadMesh, ReadModel } from '../../viewer/files/readModel.js';
import { eyeDirection } from '../../viewer/sceneSetup/placeCamera.js';
import type { CameraView, SavedView } from '../../viewer/settings/CameraView.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { drawsWithAdjacency } from '../../viewer/settings/settingValues.js';
import { isReadAlike, isSameList, type ModelChoice, NO_CHOICE } from '../../viewer/settings/shareLink.js';
import type { ChosenView } from '../../viewer/views/chooseViews.js';
import type { CodeModel } from '../code/modelSource.js';
import { BUILT_IN_MODELS } from '../models/models.js';
import { setPageState } from '../page/elements.js';
import { page } from '../page/page.js';
import { type LoadOptions, loadModelFiles } from '../reading/loadModelFiles.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import { afterFrame } from '../viewport/graphicsCard.js';
import type { Viewport } from '../viewport/Viewport.js';
import type { FileLights } from './lightModel.js';
import { type CaptionContent, ModelCaption } from './ModelCaption.js';
import { placeholderOf } from './placeholderOf.js';

/** The files of the shown model, and the names of missing ones. Built-in models have none. */
export interface ShownFiles {
  files: readonly ModelFile[];
  missing: readonly string[];
  /** The files of the archive, if the model came in one. */
  unpacked?: readonly ModelFile[] | undefined;
}

/** The shown model. */
interface Shown extends ShownFiles {
  /** The value of its setting. */
  model: Settings['model'];
  title: string;
  /** Index of the material variant, if one was chosen. */
  variant?: number | undefined;
  /** Changes that were made to what its files say. */
  changes: readonly FileChange[];
  /** Kinds of changes that were switched from what is usual, on request. */
  switched: readonly FileChangeKind[];
  /** Whether backs of its surfaces are hidden that could be seen. */
  hidesBacks: boolean;
  /** How it was simplified, if it was. */
  simplified?: ReadMesh['simplified'];
  /** The original radius of a model that is drawn as a scene; undefined for a single mesh. */
  sceneRadius?: number | undefined;
  /** Whether it is a single mesh with border edges, whose surfaces are double-sided. */
  isOpen: boolean;
  /** What was read, if it is a mesh of several parts, which is built anew when parts of it are hidden or shown. */
  joined?: ReadMesh | undefined;
}

/** A model by its setting, with its files if it is the user's own. */
interface Wanted {
  model: Settings['model'];
  files?: readonly ModelFile[] | undefined;
  /** What is selected of its file. */
  choice: ModelChoice;
}

/** A load from its request on. */
interface Load extends Wanted {
  /** Where the files are to be fetched from. */
  address?: string;
  /** Whether the camera frames the model. */
  isFramed: boolean;
  /** Whether the user opened these files just now. Otherwise the settings name the model already, and showing it changes none of them. */
  isOpened?: boolean;
  /** Whether the user chose another variant, which is a step of the history. */
  isChosen?: boolean;
  /** Whether its up axis is another one, because the user chose to leave it, or not. */
  isTurned?: boolean;
  /** Hidden parts by name, where their indices may be others than those of the choice. */
  hiddenNames?: ReadonlySet<string> | undefined;
  /** Whether the model gets a light that suits its view, if it brings no look of its own. */
  isLit?: boolean;
  /** Whether its placeholder is shown. */
  hasPlaceholder?: boolean;
  /** The views that show the user's own model best. */
  views?: readonly ChosenView[] | undefined;
}

/** A model that the user opened. */
export interface OpenedModel {
  /** Whether it differs from the previous model, rather than completing it with missing pictures. */
  isOther: boolean;
  /** The look, camera and strokes that came with the model, if any. */
  drawing: BundledDrawing | undefined;
  /** Views of its cameras and lights. */
  views: readonly SavedView[];
}

/** The result of loading: files opened by the user, a model named by the settings, the same without its hidden parts, or still the previous model. */
export type ModelEnd = 'opened' | 'restored' | 'hidden' | 'failed';

/**
 * Loads models and shows them. A load is one task of the slot `model`, whose signal aborts all of its steps: another request ends it.
 *
 * | state       | the page shows               | `load`           | `before` | leads to |
 * | ----------- | ---------------------------- | ---------------- | -------- | -------- |
 * | empty       | nothing                      | none             | none     | loading, at a request |
 * | loading     | the former model, if any     | the request      | none     | placeholder, for a large mesh; shown; failed; loading, at another request |
 * | placeholder | a copy that is not baked     | `hasPlaceholder` | the page | shown; failed; loading, at another request, which keeps the copy and `before` |
 * | shown       | the model that `shown` names | its request      | none     | loading, at a request |
 * | failed      | what it did before the load  | that of `shown`  | none     | loading, at a request |
 */
export class ModelLoader {
  shown: Shown;
  /** The latest request. After a failure, one for the shown model. */
  private load: Load | undefined;
  /** The page before the first of the placeholders shown since. */
  private before:
    | {
        settings: Pick<Settings, 'upAxis' | 'lightAzimuth' | 'lightElevation'>;
        title: string;
        caption: CaptionContent | undefined;
        place: CameraView | undefined;
      }
    | undefined;
  /** Where this page has put the light for a model. */
  private lit: Pick<Settings, 'lightAzimuth' | 'lightElevation'> | undefined;
  /** Fetched with the first model that needs it. */
  private lights: FileLights | undefined;
  private readonly caption = new ModelCaption(page.modelCaption);
  /** Parts that are being hidden; undefined if those of the shown model are. */
  private hiding: readonly number[] | undefined;
  private readonly addresses = new WeakMap<readonly ModelFile[], string>();

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
    private readonly tasks: TaskRunner,
    /** Called when loading has changed the settings. */
    private readonly onChange: (end: ModelEnd, opened?: OpenedModel) => void,
  ) {
    this.shown = {
      model: settings.model,
      title: '',
      files: [],
      missing: [],
      changes: [],
      switched: [],
      hidesBacks: false,
      isOpen: false,
    };
  }

  // ── Requests ──

  /** Shows the built-in model of the settings. */
  showChosen(choice = NO_CHOICE): void {
    const { model } = this.settings;
    // Not framed, because a link may have placed the camera.
    if (model !== 'file') void this.start({ model, choice, isFramed: false });
  }

  /** As {@link showChosen}, but only if nothing is shown or being loaded. */
  showSomething(): void {
    if (!this.viewport.model && !this.isLoading) this.showChosen();
  }

  /** Shows an earlier model, or one of a link, which the settings name already. @param isFramed whether the camera frames the model */
  restore(wanted: Wanted, isFramed: boolean): void {
    const { load } = this;
    const { model, files, choice } = wanted;
    if (model === load?.model && files === load.files && isReadAlike(choice, load.choice)) {
      load.choice = choice;
      load.hiddenNames = undefined;
      this.poseClip(choice);
      if (!this.isReading) this.hide(choice.hidden ?? []);
    } else if (model !== 'file' || files) void this.start({ ...wanted, isFramed });
  }

  /** Shows the built-in model of the settings after the user has chosen it. Resets the up axis. */
  changeModel(): void {
    const { settings } = this;
    const { model } = settings;
    if (model === 'file') return;
    settings.upAxis = SETTINGS.upAxis.default;
    void this.start({ model, choice: NO_CHOICE, isFramed: true, isLit: this.isLightOfPage });
  }

  /** Shows the user's own model. */
  showFiles(files: readonly ModelFile[]): Promise<void> {
    // A model completed with missing pictures is not framed again.
    const isFramed = !files.some((file) => this.shown.files.includes(file));
    const choice = isFramed ? NO_CHOICE : this.choice;
    return this.start({ model: 'file', files, choice, isFramed, isOpened: true, isLit: isFramed });
  }

  /** Fetches a model from another site, to which the user has agreed, and shows it with the present settings. */
  showAddress(address: string, isFramed: boolean, choice: ModelChoice): void {
    void this.start({ model: 'file', address, choice, isFramed });
  }

  /** Shows a material variant of the user's own model, by index; undefined shows the default materials. */
  showVariant(variant: number | undefined): void {
    const { files } = this.shown;
    void this.start({ model: 'file', files, choice: { ...this.choice, variant }, isFramed: false, isChosen: true });
  }

  /** Reads the user's own model again with some kinds of changes switched, in the order of `FILE_CHANGE_KINDS`. */
  readSwitched(switched: readonly FileChangeKind[]): void {
    const { files } = this.shown;
    const { names = [] } = this.viewport.model?.parts ?? {};
    const choice = { ...this.choice, switched };
    // The file may have other parts then.
    const hiddenNames = new Set(this.hidden.map((part) => names[part]));
    const isTurned = switched.includes('up') !== this.shown.switched.includes('up');
    void this.start({ model: 'file', files, choice, hiddenNames, isTurned, isFramed: false, isChosen: true });
  }

  /** Selects a clip of the shown model. */
  set clip(clip: number) {
    const choice = { ...this.choice, clip: clip || undefined };
    if (this.load && !this.isLoading) this.load.choice = choice;
    this.poseClip(choice);
  }

  /**
   * Hides parts of the shown model, by their indices in rising order, and shows the others. Does nothing while another model is read.
   *
   * @returns whether that is a change, now or soon
   */
  hide(hidden: readonly number[]): boolean {
    const { viewport, shown } = this;
    const { parts } = viewport.model ?? {};
    if (!parts || this.isReading || !this.load) return false;
    const known = hidden.filter((part) => part < parts.names.length);
    if (isSameList(known, this.hidden)) return false;
    this.load.choice = { ...this.load.choice, hidden: known };
    if (parts.hide) {
      parts.hide(known);
      viewport.partsChanged();
    } else if (shown.joined) void this.buildWithout(shown.joined, known);
    return true;
  }

  /** Builds the shown mesh again without some of its parts. */
  private async buildWithout(read: ReadMesh, hidden: readonly number[]): Promise<void> {
    const { viewport, settings } = this;
    this.hiding = hidden;
    const end = await this.tasks.run('model', async (report, signal) => {
      const { model } = await buildModel(read, report, signal, drawsWithAdjacency(settings), () => hidden);
      if (read.extras) model.extras = read.extras;
      try {
        await viewport.shown.dress(model, signal);
      } catch (error) {
        model.dispose();
        throw error;
      }
      viewport.frames.fadeIntoNext();
      viewport.shown.replace(model);
    });
    if (end === 'replaced') return;
    this.hiding = undefined;
    if (this.load) this.load.choice = { ...this.load.choice, hidden: this.hidden };
    this.onChange('hidden');
  }

  // ── The shown model ──

  /** Whether another model is read, or the shown one in another way. */
  private get isReading(): boolean {
    return this.isLoading && this.hiding === undefined;
  }

  /** The indices of the hidden parts of the shown model, or of those that are being hidden, in rising order. */
  get hidden(): readonly number[] {
    return this.hiding ?? this.viewport.model?.parts?.hidden ?? [];
  }

  get isLoading(): boolean {
    return this.tasks.isRunning('model');
  }

  /** The files of the shown model, if it is the user's own. */
  get ownFiles(): readonly ModelFile[] | undefined {
    return this.shown.model === 'file' ? this.shown.files : undefined;
  }

  /** The URL of the shown model, if it came from the web. */
  get address(): string | undefined {
    return this.ownFiles && this.addresses.get(this.ownFiles);
  }

  /** Sets the URL from which stored files came. */
  cameFrom(files: readonly ModelFile[], address: string): void {
    this.addresses.set(files, address);
  }

  /** Names of the shown model's material variants. */
  get variants(): readonly string[] {
    return this.shown.model === 'file' ? (this.viewport.model?.extras.variants ?? []) : [];
  }

  /** Index of the shown material variant, if one was chosen. */
  get variant(): number | undefined {
    return this.shown.variant;
  }

  /** What is selected of the shown model. */
  get choice(): ModelChoice {
    const { clip = 0 } = this.viewport.model?.motion ?? {};
    const { variant } = this.shown;
    const switched = this.shown.switched.length > 0 ? this.shown.switched : undefined;
    const { hidden } = this;
    return { variant, clip: clip > 0 ? clip : undefined, switched, hidden: hidden.length > 0 ? hidden : undefined };
  }

  /** The shown model in the form that copied code needs. */
  get codeModel(): CodeModel {
    const { model, title, sceneRadius, isOpen } = this.shown;
    const { root, motion, parts } = this.viewport.model ?? {};
    const { clip: index = -1, time = 0, isPlaying = false } = motion ?? {};
    return {
      model,
      title,
      sceneRadius,
      isOpen,
      hasParts: parts !== undefined,
      place: root && sceneRadius ? { scale: root.scale.x, position: root.position.toArray() } : undefined,
      clip: index === -1 ? undefined : { index, time, isPlaying },
    };
  }

  private poseClip({ clip = 0 }: ModelChoice): void {
    const { motion } = this.viewport.model ?? {};
    if (!motion || motion.clip === clip) return;
    motion.clip = clip;
    this.viewport.frames.invalidate();
  }

  // ── Steps of a load ──

  private async start(load: Load): Promise<void> {
    const { settings, viewport, shown } = this;
    this.load = load;
    this.hiding = undefined;
    if (!viewport.isLost) setPageState('loading');
    const end = await this.tasks.run('model', async (report, signal) => {
      // Preloads all techniques, so that each is drawn in the very frame in which it is chosen.
      const techniques = HatchingMaterial.preload();
      if (!viewport.shown.drawn) void techniques.then(() => viewport.buildAhead());
      const lights = load.isLit || load.isOpened ? this.fetchLights() : undefined;
      const onCoarse = async (coarse: ReadModel): Promise<void> => {
        // The placeholder needs the light of the final model, since all strokes would turn otherwise.
        await lights?.catch(() => {});
        if (!signal.aborted) this.showPlaceholder(load, coarse);
      };
      const reading = this.read(load, { signal, onStage: report, onCoarse });
      const [read] = await Promise.all([reading, techniques, lights]);
      signal.throwIfAborted();
      this.showPlaceholder(load, read);
      // Without a graphics card, frames and long tasks share the processor, and the frame would take twice as long.
      if (load.hasPlaceholder) await afterFrame(viewport.context);
      signal.throwIfAborted();
      const built = await buildModel(read, report, signal, drawsWithAdjacency(settings), (names) =>
        hiddenOf(load, names),
      );
      try {
        await viewport.shown.dress(built.model, signal);
      } catch (error) {
        built.model.dispose();
        throw error;
      }
      report('drawing', 1);
      const details = load.views ? [] : await this.findViews(load, read, built.model, signal);
      this.show(load, read, { ...built, details });
    });
    // A drawing that came with the model may hide parts of it.
    if (end === 'done' && !load.hiddenNames && this.hide(load.choice.hidden ?? [])) this.onChange('hidden');
    if (end !== 'failed') return;
    this.removePlaceholder();
    settings.model = shown.model;
    this.load = { model: shown.model, files: this.ownFiles, choice: this.choice, isFramed: false };
    this.onChange('failed');
  }

  private async fetchLights(): Promise<void> {
    const { FileLights } = await import('./lightModel.js');
    this.lights ??= new FileLights(this.viewport, this.settings);
  }

  private async read(load: Load, options: LoadOptions): Promise<ReadModel | BuiltInScene> {
    const { model, address, choice } = load;
    if (model !== 'file') {
      options.onStage(`fetching ${BUILT_IN_MODELS[model].title}`);
      return BUILT_IN_MODELS[model].load(options);
    }
    if (address !== undefined) {
      load.files = await fetchFiles(address, options);
      this.addresses.set(load.files, address);
    }
    const { variant, switched } = choice;
    const viewsFor = load.isOpened || load.isTurned ? 'file' : this.settings.upAxis;
    const read = await loadModelFiles(load.files!, {
      ...options,
      variant,
      switched: switched?.length ? switched : undefined,
      viewsFor,
    });
    if (read.kind === 'mesh') load.views = read.views;
    return read;
  }

  /**
   * Finds the views of the user's own model that is drawn as a scene, and leaves out cameras that do not see it.
   *
   * @returns notes on these cameras
   */
  private async findViews(
    load: Load,
    read: ReadModel | BuiltInScene,
    model: HatchedModel,
    signal: AbortSignal,
  ): Promise<readonly string[]> {
    if (load.model !== 'file') return [];
    const [{ sceneTriangles }, { findViews }, { sightedCameras }] = await Promise.all([
      import('../../viewer/views/sceneTriangles.js'),
      import('../reading/findViews.js'),
      import('../../viewer/views/cameraSights.js'),
    ]);
    const up = load.isOpened || load.isTurned ? (model.stands ?? read.upAxis) : this.settings.upAxis;
    const { extras } = model;
    const request = { triangles: sceneTriangles(model.root), up, cameras: extras.cameras };
    const { views, sights } = await findViews(request, signal);
    load.views = views;
    const { cameras, details } = sightedCameras(extras.cameras, sights);
    model.extras = { ...extras, cameras };
    return details;
  }

  /** Shows a placeholder for a large mesh: the mesh itself as far as it can be drawn before baking, or a coarse copy. */
  private showPlaceholder(load: Load, read: ReadModel | BuiltInScene): void {
    const { viewport, settings } = this;
    // A placeholder is of the whole mesh.
    const isWhole = read.kind !== 'mesh' || hiddenOf(load, read.mesh.parts?.names ?? []).length === 0;
    const placeholder = isWhole ? placeholderOf(read, settings) : undefined;
    if (!placeholder) return;
    if ('extras' in read && read.extras) placeholder.extras = read.extras;
    if (load.model === 'file' && 'views' in read) load.views ??= read.views;
    const { upAxis, lightAzimuth, lightElevation } = settings;
    this.before ??= {
      settings: { upAxis, lightAzimuth, lightElevation },
      title: document.title,
      caption: this.caption.content,
      place: viewport.view.ownPlace,
    };
    load.hasPlaceholder = true;
    if (load.isOpened) settings.upAxis = read.upAxis;
    const { title, view } = named(load, read);
    this.name({ title, statistics: placeholder.statistics, notes: [], details: [] });
    if (viewport.shown.isPlaceholder) viewport.frames.fadeIntoNext();
    viewport.shown.setPlaceholder(placeholder, view);
    if (load.isFramed) this.place(load, read);
    this.light(load, read);
  }

  private show(
    load: Load,
    read: ReadModel | BuiltInScene,
    {
      model: next,
      notes,
      details: more,
    }: { model: HatchedModel; notes: readonly string[]; details: readonly string[] },
  ): void {
    const { settings, viewport } = this;
    const { model, files = [], choice, isFramed, isOpened = false, hasPlaceholder = false } = load;
    const { title, view } = named(load, read);
    const { variant = -1, clip } = choice;
    const { statistics } = next;
    const isMesh = read.kind === 'mesh';
    this.before = undefined;
    this.shown = {
      model,
      title,
      files: model === 'file' ? files : [],
      missing: [],
      ...(model === 'file' && 'missing' in read && { missing: read.missing, unpacked: read.unpacked }),
      variant: next.extras.variants[variant] === undefined ? undefined : variant,
      changes: model === 'file' && 'changes' in read ? read.changes : [],
      switched: (model === 'file' && choice.switched) || [],
      hidesBacks: next.hidesBacks,
      simplified: isMesh ? read.simplified : undefined,
      sceneRadius: isMesh ? undefined : 1 / next.root.scale.x,
      isOpen: isMesh && isOpen(statistics),
      joined: isMesh && read.mesh.parts ? read : undefined,
    };
    if (next.motion && clip !== undefined) next.motion.clip = clip;
    settings.model = model;
    if ((isOpened && !hasPlaceholder) || load.isTurned)
      settings.upAxis = (model === 'file' && next.stands) || read.upAxis;
    if (viewport.shown.isPlaceholder) viewport.frames.fadeIntoNext();
    viewport.shown.set(next, view, hasPlaceholder);
    // The user may have moved the camera while the placeholder was shown.
    if (isFramed && !hasPlaceholder) this.place(load, read);
    if (!hasPlaceholder) this.light(load, read);
    const ofFile = isOpened && this.lights ? this.lights.viewsOf(next) : { views: [], notes: [] };
    // Notes on omissions matter for the user's own models only.
    const isOwn = model === 'file';
    const details = isOwn && 'details' in read ? [...read.details, ...more] : [];
    this.name({ title, statistics, notes: isOwn ? [...notes, ...ofFile.notes] : [], details });
    if (!isOpened && !load.isChosen) this.onChange('restored');
    else
      this.onChange('opened', {
        isOther: isFramed,
        drawing: isOpened && 'drawing' in read ? read.drawing : undefined,
        views: ofFile.views,
      });
    page.lamp.hidden = false;
  }

  /** Frames the model. One that the user opened is seen through the first camera of its file, if it brings no view of its own. */
  private place({ isOpened }: Load, read: ReadModel | BuiltInScene): void {
    this.viewport.view.frame();
    if (isOpened && !('drawing' in read && read.drawing)) this.lights?.lookThroughCamera();
  }

  /** Lights the model, unless it brings its own look. */
  private light({ isLit }: Load, read: ReadModel | BuiltInScene): void {
    if (!isLit || !this.lights || ('drawing' in read && read.drawing)) return;
    this.relight(this.lights);
  }

  /** Lights the model for a view that was found for it, unless the user has put the light elsewhere. */
  lightForView(): void {
    if (this.isLightOfPage && this.lights) this.relight(this.lights);
  }

  private relight(lights: FileLights): void {
    lights.light();
    const { lightAzimuth, lightElevation } = this.settings;
    this.lit = { lightAzimuth, lightElevation };
  }

  /** Whether the light is where the page put it, at the start or for a model, and not where the user put it. */
  private get isLightOfPage(): boolean {
    const { lightAzimuth, lightElevation } = this.settings;
    const first = { lightAzimuth: SETTINGS.lightAzimuth.default, lightElevation: SETTINGS.lightElevation.default };
    return [this.lit, first].some(
      (place) => place?.lightAzimuth === lightAzimuth && place.lightElevation === lightElevation,
    );
  }

  /** Restores the page to its state before the placeholder, because its model could not be loaded. */
  private removePlaceholder(): void {
    const { viewport, before } = this;
    if (!before) return;
    this.before = undefined;
    Object.assign(this.settings, before.settings);
    viewport.shown.removePlaceholder();
    document.title = before.title;
    this.caption.show(before.caption);
    if (before.place) viewport.view.place = before.place;
    else viewport.view.frame();
  }

  private name(content: CaptionContent): void {
    this.caption.show(content);
    document.title = `${shownName(content.title)}, hatched`;
  }
}

/** The indices of the parts that a load hides, in rising order. */
function hiddenOf({ choice, hiddenNames }: Load, names: readonly string[]): number[] {
  const hidden = new Set(choice.hidden);
  return [...names.keys()].filter((part) => hiddenNames?.has(names[part]) ?? hidden.has(part));
}

/** The title of a model, and the direction to the eye when it is framed, if not the default. */
function named(
  { model, views }: Load,
  { name }: ReadModel | BuiltInScene,
): { title: string; view?: [number, number, number] } {
  if (model !== 'file') return BUILT_IN_MODELS[model];
  const [best] = views ?? [];
  return best ? { title: name, view: eyeDirection(best.azimuth, best.elevation).toEye.toArray() } : { title: name };
}

async function fetchFiles(address: string, { signal, onStage }: LoadOptions): Promise<readonly ModelFile[]> {
  const { describeAddress, fetchModel } = await import('../fetch/fetchModel.js');
  const stage = `fetching ${shownName(describeAddress(address).name)}`;
  onStage(stage);
  return [await fetchModel(address, { signal, onProgress: (progress) => onStage(stage, progress) })];
}
