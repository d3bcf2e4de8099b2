import type { HatchingTechnique, Medium } from '../../look/hatchingProperties.js';
import type { MaterialPart } from './MaterialPart.js';
import { fetchedPart, fetchPart, type PartName, partNameOf } from './parts.js';

/** The part that the program of one material uses. */
export class PartInUse {
  /** The part; null if the program needs none. */
  part: MaterialPart | null = null;
  private awaited: PartName | null = null;

  /** @param onFetched called when a missing part has loaded */
  constructor(private readonly onFetched: () => void) {}

  /**
   * Uses the part that a look needs, or fetches it.
   *
   * @returns whether it has loaded; if not, the previous part stays in use
   */
  take({ technique, medium }: { technique: HatchingTechnique; medium: Medium }): boolean {
    const name = partNameOf(technique, medium);
    const part = name && fetchedPart(name);
    if (part !== undefined) this.part = part;
    else if (this.awaited !== name) this.await(name!);
    return part !== undefined;
  }

  private await(name: PartName): void {
    this.awaited = name;
    const end = (): void => {
      if (this.awaited === name) this.awaited = null;
    };
    fetchPart(name).then(() => {
      end();
      this.onFetched();
    }, end);
  }
}
