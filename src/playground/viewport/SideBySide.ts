import { MathUtils, type WebGLRenderer } from 'three';
import type { Look } from '../../viewer/settings/lookOf.js';

/** The two sides of a sides: the technique of the settings, and the one that it is compared with. */
export type Side = 'drawn' | 'compared';

/** The part of a picture that is drawn into the canvas at once, in the renderer's pixels. */
export interface Tile {
  viewWidth: number;
  x: number;
  width: number;
  height: number;
  /** Whether the technique of the settings is drawn alone, also while another is compared with it. */
  isUndivided?: boolean;
}

/**
 * Pixels that are drawn beyond the edge of a part, where another part follows: outlines look at what lies around them. Wide accents of
 * large prints look no farther than this.
 */
export const MARGIN = 64;

/** The sides that a look draws. */
export const sidesOf = ({ compared }: Look): Side[] => (compared ? ['drawn', 'compared'] : ['drawn']);

/** Draws one technique, or two side by side: the compared one is left of a divider. */
export class SideBySide {
  /** Returns the place of the divider in every frame, as a share of the width; undefined if nothing is compared. */
  divider: (() => number) | undefined;

  /**
   * @param use selects the materials of a side for the next rendering
   * @param render draws with them
   */
  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly use: (side: Side) => void,
    private readonly render: () => void,
  ) {}

  /**
   * Draws one tile of a picture that is `viewWidth` wide. The tile begins `x` pixels from the left and fills the canvas. The tile
   * of an ordinary frame is the whole picture.
   */
  drawTile({ viewWidth, x, width, height, isUndivided = false }: Tile): void {
    const { renderer } = this;
    const share = isUndivided ? undefined : this.divider?.();
    this.use('drawn');
    if (share === undefined) {
      this.render();
      return;
    }
    const split = MathUtils.clamp(Math.round(share * viewWidth) - x, 0, width);
    renderer.setScissorTest(true);
    // What is drawn beyond the divider is drawn over by the other side.
    const from = Math.max(0, split - MARGIN);
    renderer.setScissor(from, 0, width - from, height);
    if (split < width) this.render();
    this.use('compared');
    renderer.setScissor(0, 0, split, height);
    if (split > 0) this.render();
    renderer.setScissorTest(false);
  }
}
