import { ModelError } from '../../files/common/ModelError.js';
import type { Settings } from '../../settings/settings.js';
import { readLink } from '../../settings/shareLink.js';
import { askToFetch } from '../loading/ask.js';
import type { MapLoader } from '../loading/MapLoader.js';
import type { ModelLoader } from '../loading/ModelLoader.js';
import type { DrawingState, LookState } from './DrawingState.js';
import type { Keeper } from './Keeper.js';
import { LatestRequest } from './LatestRequest.js';
import type { PageAddress } from './PageAddress.js';

/** What links are shown with. */
interface LinkHost {
  settings: Settings;
  address: PageAddress;
  keeper: Keeper;
  modelLoader: ModelLoader;
  mapLoader: MapLoader;
  /** Takes over settings and camera, and loads the model and the map that they ask for. */
  showState(state: DrawingState): void;
  /** As `showState`, but for the model. */
  showLook(state: LookState): void;
  recordChange(): void;
}

/**
 * Shows drawings that take a while, because the user is asked first or the browser keeps them. The latest is shown: of one that was
 * asked for before, nothing more is done.
 */
export class LinkFollower {
  private readonly asked = new LatestRequest();

  constructor(private readonly host: LinkHost) {}

  /** Shows what the page's address asks for. Resolves when that is known and loading. */
  async follow(): Promise<void> {
    const { settings } = this.host;
    // Nobody is to agree to what the address does not ask for any more.
    this.asked.drop();
    const { drawing } = this.host.address;
    const { settings: next, camera, address, views } = readLink(this.host.address.read());
    if (drawing !== undefined) return this.openKept(drawing);
    // While a model from the web is asked about and fetched, the one that is shown stays.
    if (address === undefined) this.host.showState({ settings: next, camera, files: undefined, views });
    else this.host.showLook({ settings: { ...next, model: settings.model }, camera, views });
    this.host.recordChange();
    if (address !== undefined) await this.showAddress(address, camera === undefined);
  }

  /** Shows a model from another site, if the user agrees. */
  async showAddress(address: string, isFramed: boolean): Promise<void> {
    const isAgreed = await this.asked.run((signal) => askToFetch(address, signal));
    const { modelLoader } = this.host;
    if (isAgreed) modelLoader.showAddress(address, isFramed);
    else if (isAgreed === false) modelLoader.showSomething();
  }

  /** Shows a kept drawing. @throws ModelError with one sentence for the user, if there is none */
  async openKept(id: string): Promise<void> {
    const { keeper, modelLoader, mapLoader } = this.host;
    const isShown = await this.asked.run(async (signal) => {
      const kept = await keeper.open(id, signal).catch(() => 'silence' as const);
      if (signal.aborted) return;
      if (kept === undefined || kept === 'silence') {
        void mapLoader.showChosen();
        throw new ModelError(
          kept === undefined
            ? 'That drawing is no longer kept.'
            : 'The browser does not give back the drawing that it keeps: open your model again.',
        );
      }
      const { settings: next, address: origin, views } = readLink(kept.drawing.link);
      const { model: files, map } = kept.files;
      if (files) next.model = 'file';
      if (files && origin !== undefined) modelLoader.cameFrom(files, origin);
      this.host.showState({ settings: next, camera: kept.drawing.camera, files, views });
      if (map) await mapLoader.showFiles(map, true);
      return true;
    });
    if (isShown) this.host.recordChange();
  }
}
