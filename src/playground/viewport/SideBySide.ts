import { MathUtils, type WebGLRenderer } from 'three';
import type { Look } from '../../viewer/settings/lookOf.js';

/** The sides of a comparison: the technique of the settings, and the compared one. */
export type Side = 'drawn' | 'compared';

/** The part of a picture that fills the canvas, in device pixels. */
export interface Tile {
  viewWidth: number;
  x: number;
  width: number;
  height: number;
  /** Whether only the technique of the settings is drawn, even during a comparison. */
  isUndivided?: boolean;
}

/**
 * Pixels drawn beyond the edge of a part that continues: outlines examine their surroundings. Wide accents of large prints look no farther
 * than this.
 */
export const MARGIN = 64;

/** The sides that a look draws. */
export const sidesOf = ({ compared }: Look): Side[] => (compared ? ['drawn', 'compared'] : ['drawn']);

/** Draws one technique, or two side by side, with the compared one left of a divider. */
export class SideBySide {
  /** Returns the position of the divider in every frame, as a share of the width; undefined without a comparison. */
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
   * Draws one tile of a picture that is `viewWidth` wide. The tile begins `x` pixels from the left and fills the canvas. An ordinary frame
   * is one tile.
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
    // The part beyond the divider is overdrawn by the other side.
    const from = Math.max(0, split - MARGIN);
    renderer.setScissor(from, 0, width - from, height);
    if (split < width) this.render();
    this.use('compared');
    renderer.setScissor(0, 0, split, height);
    if (split > 0) this.render();
    renderer.setScissorTest(false);
  }
}
