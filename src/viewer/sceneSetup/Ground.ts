import { Group, Mesh, PlaneGeometry, type Scene } from 'three';
import { HatchingMaterial, prepareHatchingGeometry, type SceneExtent, type TonalArtMap } from 'three-hatching';
import { BLANK } from '../drawing/HatchedModel.js';
import { meshesOf } from '../drawing/meshesOf.js';
import type { EitherMaterial } from '../drawing/NodeMakers.js';
import { parameterSetter } from '../drawing/parameterSetter.js';
import { materialSizesIn } from '../drawing/picturedSizes.js';
import type { Look } from '../settings/lookOf.js';
import type { Layer } from './layers.js';

/**
 * The size of the ground in radii of the model: large enough for the longest shadow, and for a horizon. It is divided into this many
 * parts along each side, so that strokes follow perspective and lamps where a technique has a frame per triangle.
 */
export const GROUND = { size: 40, parts: 40 } as const;
/** After this many changes of the material, of which a look can take several, programs of earlier looks are freed. */
const MANY_VERSIONS = 24;

/** What the model stands on: a sheet that shows nothing but its shadow, or a floor. It is drawn with the strokes of the model. */
export class Ground {
  private readonly holder = new Group();
  private isMade = false;
  private freedVersion = 0;
  private kind: Look['ground'] = 'none';

  /**
   * @param onReady called when the ground is made and can be drawn
   * @param material for the renderer that draws it
   */
  constructor(
    scene: Scene,
    private readonly onReady: () => void,
    private readonly material: EitherMaterial = new HatchingMaterial(),
  ) {
    this.holder.visible = false;
    scene.add(this.holder);
  }

  /** The height at which the ground lies, in world units. */
  set height(y: number) {
    this.holder.position.y = y;
  }

  get height(): number {
    return this.holder.position.y;
  }

  /** What stands on it, by which it fades with its depth. */
  set extent(extent: SceneExtent | null) {
    this.material.extent = extent;
  }

  set tonalArtMap(map: TonalArtMap) {
    this.material.tonalArtMap = map;
  }

  apply(look: Look): void {
    this.kind = look.ground;
    this.holder.visible = look.showsGround;
    if (this.kind === 'none') return;
    if (!this.isMade) void this.make();
    parameterSetter(look.drawn)(this.material);
    if (this.kind === 'shadow') Object.assign(this.material, look.groundShadow);
    this.showPaper(true);
    this.freePrograms();
  }

  /** Hides the ground until a look is applied again. */
  hide(): void {
    this.holder.visible = false;
  }

  /** Frees the programs of earlier looks: three.js keeps them until the material is disposed of, and this one is never replaced. */
  private freePrograms(): void {
    if (this.material.version - this.freedVersion < MANY_VERSIONS) return;
    this.freedVersion = this.material.version;
    this.material.dispose();
  }

  /**
   * Sets how wide strokes are.
   *
   * @param share of their width that they have on a small sheet
   * @param scale of a picture whose size is not that of the page
   */
  setWidths(look: Look, share: number, scale = 1): void {
    Object.assign(this.material, materialSizesIn(look, share, scale));
  }

  /**
   * Has shadows dissolve before the edges of the sheet, unless they are not to dissolve at all.
   *
   * @param fade how fast, at least
   */
  endShadows({ groundShadow }: Look, fade: number): void {
    if (this.kind !== 'shadow') return;
    const { shadowFade } = groundShadow;
    this.material.shadowFade = shadowFade > 0 ? Math.max(shadowFade, fade) : 0;
  }

  /** Shows or hides the paper of a floor. The sheet that shows shadows has none. */
  showPaper(shown: boolean): void {
    const { material } = this;
    const isClear = !shown || this.kind === 'shadow';
    if (material.transparent !== isClear) material.needsUpdate = true;
    material.transparent = isClear;
    material.paperOpacity = isClear ? 0 : 1;
    material.depthWrite = !isClear;
  }

  /** Shows what a layer holds of the ground: `shadow` its strokes, `colour` the paper of a floor; or shows all of the ground again. */
  showLayer(layer: Layer | undefined, look: Look): void {
    if (layer === undefined) {
      this.apply(look);
      return;
    }
    const isFloor = this.kind === 'floor';
    this.holder.visible &&= layer === 'shadow' || (layer === 'colour' && isFloor);
    this.showPaper(layer === 'colour');
    if (layer === 'colour') this.material.toneCurve = BLANK;
  }

  /** Frees its material and geometry, and takes it from the scene. */
  dispose(): void {
    this.holder.removeFromParent();
    for (const { geometry } of meshesOf(this.holder)) geometry.dispose();
    this.material.dispose();
  }

  private async make(): Promise<void> {
    this.isMade = true;
    const plane = new PlaneGeometry(GROUND.size, GROUND.size, GROUND.parts, GROUND.parts).rotateX(-Math.PI / 2);
    const prepared = await prepareHatchingGeometry(plane, { adjacency: true }).catch((error) => {
      // The next change tries it again.
      this.isMade = false;
      throw error;
    });
    const mesh = new Mesh(prepared, this.material);
    mesh.name = 'ground';
    mesh.receiveShadow = true;
    this.holder.add(mesh);
    this.onReady();
  }
}
