import type { HatchedModel } from '../drawing/HatchedModel.js';
import { hatchModel } from '../drawing/hatchModel.js';
import type { Report } from '../drawing/Report.js';
import { standInFor } from '../drawing/standInFor.js';
import { loadModelFiles } from '../files/loadModelFiles.js';
import type { ModelFile, ReadModel } from '../files/readModel.js';
import type { BuiltInScene } from '../models/BuiltInScene.js';
import { BUILT_IN_MODELS, type BuiltInModel } from '../models/models.js';
import { setPageState } from '../page/setPageState.js';
import type { CameraView } from '../settings/CameraView.js';
import type { SettingsHistory } from '../settings/SettingsHistory.js';
import { SETTINGS, type Settings } from '../settings/settings.js';
import type { HatchingScene } from '../stage/createScene.js';
import { modelCaption } from './modelCaption.js';
import { page } from './page.js';
import type { ShownFiles } from './sortDrop.js';
import type { TaskRunner } from './TaskRunner.js';

interface LoadedModel {
  title: string;
  view?: [number, number, number] | undefined;
  read: ReadModel | BuiltInScene;
  shown?: ShownFiles;
}

/** Loads models and shows them. While one is loading, and if it fails, the previous one stays. */
export class ModelLoader {
  /** The name of the model that is shown. */
  title = '';
  /** The radius of a model that is drawn as a scene, before it was fitted. Undefined for one mesh. */
  sceneRadius: number | undefined;
  /** What the shown model was read from. Built-in models ask for nothing. */
  shownFiles: ShownFiles = { files: [], missing: [] };
  /** What a stand-in has changed on the page. */
  private beforeStandIn:
    | { upAxis: Settings['upAxis']; title: string; caption: ChildNode[]; place: CameraView | undefined }
    | undefined;
  /** The value of the setting for the model that is shown. */
  private shownModel: Settings['model'];

  constructor(
    private readonly scene: HatchingScene,
    private readonly settings: Settings,
    private readonly history: SettingsHistory,
    private readonly tasks: TaskRunner,
    /** Called when loading has changed the settings. `isNewModel` is false if it failed and they were put back. */
    private readonly onChange: (isNewModel: boolean) => void,
  ) {
    this.shownModel = settings.model;
  }

  /** Shows the built-in model that the settings ask for. */
  showChosen(): void {
    const { settings } = this;
    // A link may have placed the camera.
    if (settings.model !== 'file') void this.showBuiltIn(settings.model, false);
  }

  /**
   * As {@link showChosen}, after another model was chosen. Resets the up axis.
   *
   * @param isFramed whether the camera goes to where it sees the whole model
   */
  changeModel(isFramed = true): void {
    const { settings } = this;
    if (settings.model === 'file') return;
    settings.upAxis = SETTINGS.upAxis.default;
    void this.showBuiltIn(settings.model, isFramed);
  }

  showFiles(files: readonly ModelFile[]): Promise<void> {
    // The same model, with pictures that it lacked, stays where it is.
    const isAnother = !files.some((file) => this.shownFiles.files.includes(file));
    return this.show('file', isAnother, async (report, signal) => {
      const read = await loadModelFiles(files, { signal, onStage: report });
      return { title: read.name, read, shown: { files, missing: read.missing } };
    });
  }

  private showBuiltIn(model: BuiltInModel, isFramed: boolean): Promise<void> {
    return this.show(model, isFramed, async (report, signal) => {
      const { title, view, load } = BUILT_IN_MODELS[model];
      report(`fetching ${title}`);
      return { title, view, read: await load({ signal, onStage: report }) };
    });
  }

  private async show(
    model: Settings['model'],
    isFramed: boolean,
    load: (report: Report, signal: AbortSignal) => Promise<LoadedModel>,
  ): Promise<void> {
    const { settings, history, scene } = this;
    if (!scene.isLost) setPageState('loading');
    const end = await this.tasks.run('model', async (report, signal) => {
      const loaded = await load(report, signal);
      this.showStandIn(loaded, model, isFramed);
      const { model: next, notes } = await hatchModel(loaded.read, report, signal);
      if (signal.aborted) {
        next.dispose();
        throw signal.reason;
      }
      report('drawing', 1);
      const hasStandIn = scene.isStandIn;
      this.beforeStandIn = undefined;
      this.shownModel = model;
      this.title = loaded.title;
      this.shownFiles = loaded.shown ?? { files: [], missing: [] };
      this.sceneRadius = loaded.read.kind === 'mesh' ? undefined : 1 / next.root.scale.x;
      settings.model = model;
      if (model === 'file' && !hasStandIn) settings.upAxis = loaded.read.upAxis;
      history.adopt();
      // What is left out of our own models is no news to anyone.
      const told = model === 'file' ? notes : [];
      this.name(loaded.title, next, told);
      scene.setModel(next, loaded.view);
      // Who has looked around the stand-in goes on from there.
      if (isFramed && !hasStandIn) scene.view.frame();
      this.onChange(true);
      page.lamp.hidden = false;
    });
    if (end === 'failed') {
      this.takeStandInAway();
      // The previous model stays, and the panel must show its name again.
      settings.model = this.shownModel;
      history.adopt();
      this.onChange(false);
    }
  }

  /** Draws a large mesh at once with what is known of it. */
  private showStandIn({ read, title, view }: LoadedModel, model: Settings['model'], isFramed: boolean): void {
    const { scene, settings } = this;
    const standIn = standInFor(read, settings);
    if (!standIn) return;
    this.beforeStandIn ??= {
      upAxis: settings.upAxis,
      title: document.title,
      caption: [...page.modelCaption.childNodes],
      place: scene.view.isFramed ? undefined : scene.view.place,
    };
    if (model === 'file') settings.upAxis = read.upAxis;
    this.name(title, standIn, []);
    scene.setStandIn(standIn, view);
    if (isFramed) scene.view.frame();
  }

  /** Puts back the page as it was before a stand-in for a model that does not come. */
  private takeStandInAway(): void {
    const { scene, settings, beforeStandIn: before } = this;
    if (!before) return;
    this.beforeStandIn = undefined;
    settings.upAxis = before.upAxis;
    scene.removeStandIn();
    document.title = before.title;
    page.modelCaption.replaceChildren(...before.caption);
    if (before.place) scene.view.place = before.place;
    else scene.view.frame();
  }

  private name(title: string, { statistics }: HatchedModel, notes: readonly string[]): void {
    page.modelCaption.replaceChildren(...modelCaption(title, statistics, notes));
    document.title = `${title}, hatched`;
  }
}
