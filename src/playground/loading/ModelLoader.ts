import { HatchingMaterial } from 'three-hatching';
import type { BuiltInScene, Report } from '../../viewer/drawing/buildModel.js';
import { buildModel } from '../../viewer/drawing/buildModel.js';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { isOpen } from '../../viewer/drawing/isOpen.js';
import type { BundledDrawing } from '../../viewer/files/archives/bundle.js';
import { shownName } from '../../viewer/files/common/shownText.js';
import type { ModelFile, ReadMesh, ReadModel } from '../../viewer/files/readModel.js';
import type { CameraView } from '../../viewer/settings/CameraView.js';
import { type ModelChoice, NO_CHOICE } from '../../viewer/settings/ModelChoice.js';
import type { SavedView } from '../../viewer/settings/savedViews.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { drawsWithAdjacency } from '../../viewer/settings/settingValues.js';
import type { CodeModel } from '../code/CodeModel.js';
import { placeholderOf } from '../maps/placeholderOf.js';
import { BUILT_IN_MODELS, type BuiltInModel } from '../models/models.js';
import { setPageState } from '../page/elements.js';
import { page } from '../page/page.js';
import { loadModelFiles } from '../reading/loadModelFiles.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import { whenDrawn } from '../viewport/graphicsCard.js';
import type { Viewport } from '../viewport/Viewport.js';
import { FileViews } from './FileViews.js';
import type { lightModel } from './lightModel.js';
import { type CaptionContent, ModelCaption } from './ModelCaption.js';

/** The files of the shown model, and the names of missing ones. */
export interface ShownFiles {
  files: readonly ModelFile[];
  missing: readonly string[];
  /** The files of the archive, if the model came in one. */
  unpacked?: readonly ModelFile[] | undefined;
}

interface LoadedModel {
  title: string;
  view?: [number, number, number] | undefined;
  read: ReadModel | BuiltInScene;
  shown?: ShownFiles;
  drawing?: BundledDrawing | undefined;
  /** Lights the model for its view; undefined if its light is given. */
  light?: typeof lightModel | undefined;
}

/** A model by its setting, with its files if it is the user's own. */
interface WantedModel {
  model: Settings['model'];
  files?: readonly ModelFile[] | undefined;
  /** The variant and clip of its file. */
  choice: ModelChoice;
}

/** How a model is shown. */
interface WayToShow {
  /** Whether the camera frames the model. */
  isFramed: boolean;
  /** Whether the settings already name the model, so that showing it changes none of them. */
  isRestored: boolean;
  /** Whether the user chose another variant or clip, which is a step of the history. */
  isChosen?: boolean;
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

/** The result of loading: files opened by the user, a model named by the settings, or still the previous model. */
export type ModelEnd = 'opened' | 'restored' | 'failed';

/** Loads models and shows them. While one is loading, and if it fails, the previous one stays. */
export class ModelLoader {
  /** The name of the shown model. */
  title = '';
  /** The original radius of a model drawn as a scene. Undefined for a single mesh. */
  sceneRadius: number | undefined;
  /** Whether the model is a single mesh with border edges, whose surfaces are double-sided. */
  isOpen = false;
  /** How the shown model was simplified, if it was. */
  simplified: ReadMesh['simplified'];
  /** The files of the shown model. Built-in models have none. */
  shownFiles: ShownFiles = { files: [], missing: [] };
  /** Index of the shown material variant, if one was chosen. */
  private shownVariant: number | undefined;
  /** The page's state before a placeholder was shown. */
  private beforePlaceholder:
    | {
        settings: Pick<Settings, 'upAxis' | 'lightAzimuth' | 'lightElevation'>;
        title: string;
        caption: CaptionContent | undefined;
        place: CameraView | undefined;
      }
    | undefined;
  /** The model for which the latest placeholder was shown. */
  private placeholderFor: WantedModel | undefined;
  /** Where this page has put the light for a model. */
  private lit: Pick<Settings, 'lightAzimuth' | 'lightElevation'> | undefined;
  /** The shown model, as the value of its setting. */
  private shownModel: Settings['model'];
  /** The model that is shown or being loaded, if any. */
  private wanted: WantedModel | undefined;
  private readonly caption = new ModelCaption(page.modelCaption);
  private readonly fileViews: FileViews;
  private readonly addresses = new WeakMap<readonly ModelFile[], string>();

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
    private readonly tasks: TaskRunner,
    /** Called when loading has changed the settings. */
    private readonly onChange: (end: ModelEnd, opened?: OpenedModel) => void,
  ) {
    this.shownModel = settings.model;
    this.fileViews = new FileViews(viewport, settings);
  }

  /** Shows the built-in model of the settings. */
  showChosen(choice = NO_CHOICE): void {
    const { settings } = this;
    // Not framed, because a link may have placed the camera.
    if (settings.model !== 'file') void this.showBuiltIn(settings.model, { isFramed: false, choice });
  }

  /** As {@link showChosen}, but only if nothing is shown or being loaded. */
  showSomething(): void {
    if (!this.viewport.model && !this.isLoading) this.showChosen();
  }

  /**
   * Shows an earlier model, or one of a link, which the settings name already.
   *
   * @param files of the user's own model
   * @param isFramed whether the camera frames the model
   */
  restore({ model, files, choice }: WantedModel, isFramed: boolean): void {
    const { wanted } = this;
    if (model === wanted?.model && files === wanted.files && choice.variant === wanted.choice.variant) {
      wanted.choice = choice;
      this.poseClip(choice);
    } else if (model !== 'file') void this.showBuiltIn(model, { isFramed, choice });
    else if (files) void this.showOwn(files, { isFramed, isRestored: true }, choice);
  }

  /**
   * Shows the built-in model of the settings after the user has chosen it. Resets the up axis.
   *
   * @param isFramed whether the camera frames the model
   */
  changeModel(isFramed = true): void {
    const { settings } = this;
    if (settings.model === 'file') return;
    settings.upAxis = SETTINGS.upAxis.default;
    void this.showBuiltIn(settings.model, { isFramed, isLit: isFramed && this.isLightOfPage });
  }

  get isLoading(): boolean {
    return this.tasks.isRunning('model');
  }

  /** The files of the shown model, if it is the user's own. */
  get ownFiles(): readonly ModelFile[] | undefined {
    return this.shownModel === 'file' ? this.shownFiles.files : undefined;
  }

  /** The shown model in the form that copied code needs. */
  get codeModel(): CodeModel {
    const { shownModel: model, title, sceneRadius, isOpen } = this;
    const { root, motion } = this.viewport.model ?? {};
    const { clip: index = -1, time = 0, isPlaying = false } = motion ?? {};
    return {
      model,
      title,
      sceneRadius,
      isOpen,
      place: root && sceneRadius ? { scale: root.scale.x, position: root.position.toArray() } : undefined,
      clip: index === -1 ? undefined : { index, time, isPlaying },
    };
  }

  /** Fetches a model from another site, to which the user has agreed, and shows it with the present settings. */
  showAddress(address: string, isFramed: boolean, choice: ModelChoice): void {
    const wanted: WantedModel = { model: 'file', choice };
    void this.show(wanted, { isFramed, isRestored: true }, async (report, signal) => {
      const { describeAddress, fetchModel } = await import('./fetchModel.js');
      const viewport = `fetching ${shownName(describeAddress(address).name)}`;
      report(viewport);
      const files = [await fetchModel(address, { signal, onProgress: (progress) => report(viewport, progress) })];
      wanted.files = files;
      this.addresses.set(files, address);
      const onCoarse = (read: ReadModel): void => {
        if (!signal.aborted) this.showPlaceholder({ title: read.name, read }, { isFramed, isRestored: true });
      };
      const { variant } = choice;
      const read = await loadModelFiles(files, { signal, onStage: report, onCoarse, variant });
      const { name: title, missing, unpacked } = read;
      return { title, read, shown: { files, missing, unpacked } };
    });
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
    return this.shownModel === 'file' ? (this.viewport.model?.extras.variants ?? []) : [];
  }

  /** Shows a material variant of the user's own model, by index; undefined shows the default materials. */
  showVariant(variant: number | undefined): void {
    const { shownFiles, choice } = this;
    const way: WayToShow = { isFramed: false, isRestored: true, isChosen: true };
    void this.showOwn(shownFiles.files, way, { ...choice, variant });
  }

  /** Index of the shown material variant, if one was chosen. */
  get variant(): number | undefined {
    return this.choice.variant;
  }

  /** Selects a clip of the shown model. */
  set clip(clip: number) {
    const choice = { ...this.choice, clip: clip || undefined };
    if (this.wanted && !this.isLoading) this.wanted.choice = choice;
    this.poseClip(choice);
  }

  /** The variant and clip of the shown model. */
  get choice(): ModelChoice {
    const { clip = 0 } = this.viewport.model?.motion ?? {};
    return { variant: this.shownVariant, clip: clip > 0 ? clip : undefined };
  }

  private poseClip({ clip = 0 }: ModelChoice): void {
    const { motion } = this.viewport.model ?? {};
    if (!motion || motion.clip === clip) return;
    motion.clip = clip;
    this.viewport.frames.invalidate();
  }

  /** Shows the user's own model. */
  showFiles(files: readonly ModelFile[]): Promise<void> {
    // A model completed with missing pictures is not framed again.
    const isFramed = !files.some((file) => this.shownFiles.files.includes(file));
    return this.showOwn(files, { isFramed, isRestored: false }, isFramed ? NO_CHOICE : this.choice);
  }

  private showOwn(files: readonly ModelFile[], way: WayToShow, choice: ModelChoice): Promise<void> {
    const { variant } = choice;
    return this.show({ model: 'file', files, choice }, way, async (report, signal) => {
      const lighting = fetchLight();
      const lightOf = async ({ drawing }: ReadModel): Promise<LoadedModel['light']> =>
        way.isRestored || !way.isFramed || drawing ? undefined : lighting;
      const onCoarse = async (read: ReadModel): Promise<void> => {
        // The placeholder needs the light of the final model, since all strokes would turn otherwise.
        const light = await lightOf(read).catch(() => undefined);
        if (!signal.aborted) this.showPlaceholder({ title: read.name, read, light }, way);
      };
      const reading = loadModelFiles(files, { signal, onStage: report, onCoarse, variant });
      const [read] = await Promise.all([reading, lighting]);
      const { name: title, missing, unpacked, drawing } = read;
      const light = await lightOf(read);
      return { title, read, shown: { files, missing, unpacked }, drawing, light };
    });
  }

  /** Whether the light is where the page put it, at the start or for a model, and not where the user put it. */
  private get isLightOfPage(): boolean {
    const { settings, lit } = this;
    const places = [
      lit,
      { lightAzimuth: SETTINGS.lightAzimuth.default, lightElevation: SETTINGS.lightElevation.default },
    ];
    return places.some(
      (place) => place?.lightAzimuth === settings.lightAzimuth && place.lightElevation === settings.lightElevation,
    );
  }

  /** @param isLit whether the model gets a light that suits its view */
  private showBuiltIn(
    model: BuiltInModel,
    { isFramed, isLit = false, choice = NO_CHOICE }: { isFramed: boolean; isLit?: boolean; choice?: ModelChoice },
  ): Promise<void> {
    return this.show({ model, choice }, { isFramed, isRestored: true }, async (report, signal) => {
      const { title, view, load } = BUILT_IN_MODELS[model];
      report(`fetching ${title}`);
      const lighting = isLit ? fetchLight() : undefined;
      const onCoarse = async (read: ReadModel): Promise<void> => {
        const light = await lighting?.catch(() => undefined);
        if (!signal.aborted) this.showPlaceholder({ title, view, read, light }, { isFramed, isRestored: true });
      };
      const [read, light] = await Promise.all([load({ signal, onStage: report, onCoarse }), lighting]);
      return { title, view, read, light };
    });
  }

  private async show(
    wanted: WantedModel,
    way: WayToShow,
    load: (report: Report, signal: AbortSignal) => Promise<LoadedModel>,
  ): Promise<void> {
    const { settings, viewport } = this;
    this.wanted = wanted;
    if (!viewport.isLost) setPageState('loading');
    const end = await this.tasks.run('model', async (report, signal) => {
      // Preloads all techniques, so that each is drawn in the very frame in which it is chosen.
      const techniques = HatchingMaterial.preload();
      if (!viewport.shown.drawn) void techniques.then(() => viewport.buildAhead());
      const [loaded] = await Promise.all([load(report, signal), techniques]);
      this.showPlaceholder(loaded, way);
      if (this.hasPlaceholder) await afterFrame(viewport.context);
      signal.throwIfAborted();
      const built = await buildModel(loaded.read, report, signal, drawsWithAdjacency(settings));
      try {
        await viewport.shown.dress(built.model, signal);
      } catch (error) {
        built.model.dispose();
        throw error;
      }
      report('drawing', 1);
      this.showLoaded(wanted, loaded, built, way);
    });
    if (end === 'failed') {
      this.removePlaceholder();
      // The previous model stays, so its setting is restored.
      settings.model = this.shownModel;
      this.wanted = { model: this.shownModel, files: this.ownFiles, choice: this.choice };
      this.onChange('failed');
    }
  }

  private showLoaded(
    { model, choice }: WantedModel,
    loaded: LoadedModel,
    { model: next, notes }: { model: HatchedModel; notes: readonly string[] },
    { isFramed, isRestored, isChosen = false }: WayToShow,
  ): void {
    const { settings, viewport } = this;
    const { title, read, view, drawing, light } = loaded;
    const { hasPlaceholder } = this;
    this.beforePlaceholder = undefined;
    this.shownModel = model;
    this.title = title;
    this.shownFiles = loaded.shown ?? { files: [], missing: [] };
    this.shownVariant = next.extras.variants[choice.variant ?? -1] === undefined ? undefined : choice.variant;
    if (next.motion && choice.clip !== undefined) next.motion.clip = choice.clip;
    this.simplified = read.kind === 'mesh' ? read.simplified : undefined;
    this.sceneRadius = read.kind === 'mesh' ? undefined : 1 / next.root.scale.x;
    const { statistics } = next;
    this.isOpen = read.kind === 'mesh' && isOpen(statistics);
    settings.model = model;
    if (!isRestored && !hasPlaceholder) settings.upAxis = read.upAxis;
    if (viewport.shown.isPlaceholder) viewport.frames.fadeIntoNext();
    viewport.shown.set(next, view, hasPlaceholder);
    // The user may have moved the camera while the placeholder was shown.
    if (isFramed && !hasPlaceholder) viewport.view.frame();
    if (!hasPlaceholder) this.light(light);
    const ofFile = isRestored ? { views: [], notes: [] } : this.fileViews.of(next);
    // Notes on omissions matter for the user's own models only.
    const isOwn = model === 'file';
    const details = isOwn && 'details' in read ? read.details : [];
    this.name({ title, statistics, notes: isOwn ? [...notes, ...ofFile.notes] : [], details });
    if (isRestored && !isChosen) this.onChange('restored');
    else this.onChange('opened', { isOther: isFramed, drawing: isRestored ? undefined : drawing, views: ofFile.views });
    page.lamp.hidden = false;
  }

  /** Shows a placeholder for a large mesh: the mesh itself as far as it can be drawn before baking, or a coarse copy. */
  private showPlaceholder({ read, title, view, light }: LoadedModel, { isFramed, isRestored }: WayToShow): void {
    const { viewport, settings } = this;
    const placeholder = placeholderOf(read, settings);
    if (!placeholder) return;
    const { upAxis, lightAzimuth, lightElevation } = settings;
    // If the placeholder belongs to a model that was given up, the state before that one is what may be restored.
    if ('extras' in read && read.extras) placeholder.extras = read.extras;
    this.beforePlaceholder ??= {
      settings: { upAxis, lightAzimuth, lightElevation },
      title: document.title,
      caption: this.caption.content,
      place: viewport.view.ownPlace,
    };
    this.placeholderFor = this.wanted;
    if (!isRestored) settings.upAxis = read.upAxis;
    this.name({ title, statistics: placeholder.statistics, notes: [], details: [] });
    if (viewport.shown.isPlaceholder) viewport.frames.fadeIntoNext();
    viewport.shown.setPlaceholder(placeholder, view);
    if (isFramed) viewport.view.frame();
    this.light(light);
  }

  /** Whether a placeholder for the loading model is shown. */
  private get hasPlaceholder(): boolean {
    return this.viewport.shown.isPlaceholder && this.placeholderFor === this.wanted;
  }

  private light(light: LoadedModel['light']): void {
    if (!light) return;
    this.fileViews.light(light);
    const { lightAzimuth, lightElevation } = this.settings;
    this.lit = { lightAzimuth, lightElevation };
  }

  /** Restores the page to its state before the placeholder, because its model could not be loaded. */
  private removePlaceholder(): void {
    const { viewport, settings, beforePlaceholder: before } = this;
    if (!before) return;
    this.beforePlaceholder = undefined;
    Object.assign(settings, before.settings);
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

/** The maximum wait for a frame to be submitted, in milliseconds: a hidden page draws none. */
const FRAME_MILLISECONDS = 100;
/** The maximum wait for a frame to be drawn, in milliseconds. */
const DRAWING_MILLISECONDS = 1000;

/**
 * Resolves when the next frame is on the page. Long tasks wait for it: without a graphics card both would share the processor, and the
 * frame would take twice as long.
 */
async function afterFrame(context: WebGL2RenderingContext): Promise<void> {
  await within(FRAME_MILLISECONDS, new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))));
  await within(DRAWING_MILLISECONDS, whenDrawn(context));
}

/** Resolves with a task, or after a timeout in milliseconds. */
async function within(milliseconds: number, task: Promise<unknown>): Promise<void> {
  let timer: ReturnType<typeof setTimeout> | undefined;
  await Promise.race([task, new Promise((resolve) => (timer = setTimeout(resolve, milliseconds)))]);
  clearTimeout(timer);
}

const fetchLight = async (): Promise<typeof lightModel> => (await import('./lightModel.js')).lightModel;
