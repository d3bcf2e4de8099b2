import { Group, Mesh, PlaneGeometry, type Scene } from 'three';
import {
  HatchingMaterial,
  HatchingShadowMaterial,
  prepareHatchingGeometry,
  type SceneExtent,
  type TonalArtMap,
} from 'three-hatching';
import type { HatchingShadowNodeMaterial } from 'three-hatching/webgpu';
import { BLANK_CURVE } from '../drawing/HatchedModel.js';
import { type EitherMaterial, materialSizesIn, parameterSetter } from '../drawing/materials.js';
import { meshesOf } from '../drawing/meshes.js';
import type { Look } from '../settings/lookOf.js';

/** The layers of a saved picture, bottom first. */
export const LAYERS = ['colour', 'shadow', 'strokes', 'outline'] as const;
export type Layer = (typeof LAYERS)[number];

/**
 * The size of the ground in radii of the model: large enough for the longest shadow and a horizon. It is divided into parts, so that
 * techniques with one frame per triangle follow perspective and lamps.
 */
export const GROUND = { size: 40, parts: 40 } as const;
/** After this many material versions, several of which one look may need, programs of earlier looks are freed. */
const MANY_VERSIONS = 24;

/** The materials of a ground, for one renderer: of a floor, and of one that shows shadows alone. */
export interface GroundMaterials {
  readonly floor: EitherMaterial;
  readonly shadow: HatchingShadowMaterial | HatchingShadowNodeMaterial;
}

const glslMaterials = (): GroundMaterials => ({ floor: new HatchingMaterial(), shadow: new HatchingShadowMaterial() });

/** The ground: a surface that shows only shadows, or a floor. It is drawn with the model's strokes. */
export class Ground {
  private readonly holder = new Group();
  private mesh: Mesh | null = null;
  private isMade = false;
  private readonly freedVersions = new Map<EitherMaterial, number>();
  private kind: Look['ground'] = 'none';

  /**
   * @param onReady called when the ground can be drawn
   * @param materials for the renderer that draws it
   */
  constructor(
    scene: Scene,
    private readonly onReady: () => void,
    private readonly materials: GroundMaterials = glslMaterials(),
  ) {
    this.holder.visible = false;
    scene.add(this.holder);
  }

  /** The height of the ground, in world units. */
  set height(y: number) {
    this.holder.position.y = y;
  }

  get height(): number {
    return this.holder.position.y;
  }

  /** The extent of the model, by which the ground fades with depth. */
  set extent(extent: SceneExtent | null) {
    for (const { composition } of this.both) composition.extent = extent;
  }

  set tonalArtMap(map: TonalArtMap) {
    for (const material of this.both) material.tonalArtMap = map;
  }

  /** Resolves when the material that is drawn has its map and its code. */
  get ready(): Promise<void> {
    return this.material.ready;
  }

  apply(look: Look): void {
    this.kind = look.ground;
    this.holder.visible = look.showsGround;
    if (this.kind === 'none') return;
    if (!this.isMade) void this.make();
    parameterSetter(look.drawn)(this.material);
    if (this.kind === 'shadow') Object.assign(this.materials.shadow, look.groundShadow);
    if (this.mesh) this.mesh.material = this.material;
    this.showPaper(true);
    this.freePrograms();
  }

  /** Hides the ground until a look is applied again. */
  hide(): void {
    this.holder.visible = false;
  }

  /**
   * Frees the programs of earlier looks. three.js keeps them until the material is disposed of, and these materials live as long as the
   * page.
   */
  private freePrograms(): void {
    const { material, freedVersions } = this;
    if (material.version - (freedVersions.get(material) ?? 0) < MANY_VERSIONS) return;
    freedVersions.set(material, material.version);
    material.dispose();
  }

  /**
   * Sets the stroke width.
   *
   * @param share of the full width, below 1 on small sheets
   * @param scale of a picture relative to the page
   */
  setWidths(look: Look, share: number, scale = 1): void {
    Object.assign(this.material, materialSizesIn(look, share, scale));
  }

  /**
   * Fades shadows before the edges of the sheet, unless the look turns fading off.
   *
   * @param fade the least fading
   */
  endShadows({ groundShadow }: Look, fade: number): void {
    if (this.kind !== 'shadow') return;
    const { shadowFade } = groundShadow;
    this.materials.shadow.shadowFade = shadowFade > 0 ? Math.max(shadowFade, fade) : 0;
  }

  /** Shows or hides the paper of a floor. A ground that shows only shadows has none. */
  showPaper(shown: boolean): void {
    const { material } = this;
    const isClear = !shown || this.kind === 'shadow';
    if (material.transparent !== isClear) material.needsUpdate = true;
    material.transparent = isClear;
    material.paperOpacity = isClear ? 0 : 1;
    material.depthWrite = !isClear;
  }

  /** Shows the ground's part of a layer until a look is applied: `shadow` its strokes, `colour` the paper of a floor. */
  showLayer(layer: Layer): void {
    const isFloor = this.kind === 'floor';
    this.holder.visible &&= layer === 'shadow' || (layer === 'colour' && isFloor);
    this.showPaper(layer === 'colour');
    if (layer === 'colour') this.material.toneCurve = BLANK_CURVE;
  }

  /** Frees the materials and the geometry, and removes the ground from the scene. */
  dispose(): void {
    this.holder.removeFromParent();
    for (const { geometry } of meshesOf(this.holder)) geometry.dispose();
    for (const material of this.both) material.dispose();
  }

  /** The material that is drawn. */
  private get material(): EitherMaterial {
    return this.materials[this.kind === 'shadow' ? 'shadow' : 'floor'];
  }

  private get both(): readonly EitherMaterial[] {
    return Object.values(this.materials);
  }

  private async make(): Promise<void> {
    this.isMade = true;
    const plane = new PlaneGeometry(GROUND.size, GROUND.size, GROUND.parts, GROUND.parts).rotateX(-Math.PI / 2);
    const prepared = await prepareHatchingGeometry(plane, { adjacency: true }).catch((error) => {
      // The next change tries again.
      this.isMade = false;
      throw error;
    });
    const mesh = new Mesh(prepared, this.material);
    mesh.name = 'ground';
    mesh.receiveShadow = true;
    this.mesh = mesh;
    this.holder.add(mesh);
    this.onReady();
  }
}
