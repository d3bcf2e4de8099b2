import { hatchModel } from '../drawing/hatchModel.js';
import type { Report } from '../drawing/Report.js';
import { loadModelFiles } from '../files/loadModelFiles.js';
import type { ModelFile, ReadModel } from '../files/readModel.js';
import type { BuiltInScene } from '../models/BuiltInScene.js';
import { BUILT_IN_MODELS, type BuiltInModel } from '../models/models.js';
import { setPageState } from '../page/setPageState.js';
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
      const { model: next, notes } = await hatchModel(loaded.read, report, signal);
      if (signal.aborted) {
        next.dispose();
        throw signal.reason;
      }
      report('drawing', 1);
      this.shownModel = model;
      this.title = loaded.title;
      this.shownFiles = loaded.shown ?? { files: [], missing: [] };
      this.sceneRadius = loaded.read.kind === 'mesh' ? undefined : 1 / next.root.scale.x;
      settings.model = model;
      if (model === 'file') settings.upAxis = loaded.read.upAxis;
      history.adopt();
      // What is left out of our own models is no news to anyone.
      const told = model === 'file' ? notes : [];
      page.modelCaption.replaceChildren(...modelCaption(loaded.title, next.statistics, told));
      document.title = `${loaded.title}, hatched`;
      scene.setModel(next, loaded.view);
      if (isFramed) scene.view.frame();
      this.onChange(true);
      page.lamp.hidden = false;
    });
    if (end === 'failed') {
      // The previous model stays, and the panel must show its name again.
      settings.model = this.shownModel;
      history.adopt();
      this.onChange(false);
    }
  }
}
