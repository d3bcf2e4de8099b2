import {
  type Blending,
  type Box3,
  Color,
  CustomBlending,
  FrontSide,
  type Material,
  type Mesh,
  NoBlending,
  type Object3D,
  OneFactor,
  type Texture,
  ZeroFactor,
} from 'three';
import type {
  HatchingMaterial,
  HatchingMaterialParameters,
  HatchingOutlineMaterial,
  HatchingOutlines,
  HatchingStatistics,
  SceneExtent,
  TonalArtMap,
} from 'three-hatching';
import { GLASS, needsAdjacency, paperOfGlass } from 'three-hatching/facts';
import type {
  HatchingNodeMaterial,
  HatchingOutlineNodeMaterial,
  HatchingOutlines as NodeOutlines,
} from 'three-hatching/webgpu';
import { type ModelExtras, NO_EXTRAS } from '../files/common/ModelExtras.js';
import type { UpAxis } from '../files/mesh/UpAxis.js';
import type { Look } from '../settings/lookOf.js';
import type { ModelParts } from './ModelParts.js';
import type { Motion } from './Motion.js';
import {
  type EitherMaterial,
  materialSizesIn,
  type NodeMakers,
  outlineSizesIn,
  parameterSetter,
  releaseGraphics,
  releaseMaterial,
} from './materials.js';
import { meshesOf } from './meshes.js';
import type { ModelStatistics } from './statistics.js';

/** Blending that leaves the colour unchanged. The surface still writes depth. */
const NO_INK = { blending: CustomBlending, blendSrc: ZeroFactor, blendDst: OneFactor };

/** A tone curve that draws no ink. */
export const BLANK_CURVE: readonly (readonly [number, number])[] = [
  [0, 0],
  [1, 0],
];

/** The properties of a material that come from the model, not from the settings. */
interface Surface {
  color: Color;
  map: Texture | null;
  vertexColors: boolean;
  alphaTest: number;
  /** Whether the surface is see-through. */
  isGlass: boolean;
  metalness: number;
  blending: Blending;
  premultipliedAlpha: boolean;
  /** The stroke scale that gives one tile per world unit. */
  scale: number;
}

/** Which materials a rendering uses: those of the settings, of the compared technique, or of nodes. */
export type MaterialKind = 'drawn' | 'compared' | 'nodes';

/** The materials and outlines of one kind. */
interface MaterialSet {
  /** In the order of the surfaces. */
  materials: readonly EitherMaterial[];
  /** In the order of the meshes. */
  ofMeshes: readonly (Material | Material[])[];
  outlines: readonly (HatchingOutlines | NodeOutlines)[];
  outlineMaterials: ReadonlySet<HatchingOutlineMaterial | HatchingOutlineNodeMaterial>;
}

/**
 * What a rendering shows of a model. Surfaces without paper, colour or ink still hide what is behind them.
 *
 * | part | for |
 * | --- | --- |
 * | `whole` | a frame |
 * | `sketch` | a frame that must be drawn at once: outlines and shadows need programs or frames of their own |
 * | `ink` | a picture whose paper is transparent |
 * | `colour`, `shadow`, `strokes`, `outline` | one layer of a picture; to that of the ground's shadow a model adds nothing |
 */
const PARTS = {
  whole: { paper: true, ink: 'drawn', outlines: true, shadows: true },
  sketch: { paper: true, ink: 'drawn', outlines: false, shadows: false },
  ink: { paper: false, ink: 'drawn', outlines: true, shadows: true },
  colour: { paper: true, ink: 'blank', outlines: false, shadows: true },
  shadow: { paper: false, ink: 'hidden', outlines: false, shadows: true },
  strokes: { paper: false, ink: 'drawn', outlines: false, shadows: true },
  // Outlines are not drawn for a material with `colorWrite: false`.
  outline: { paper: false, ink: 'clear', outlines: true, shadows: true },
} as const;

export type ModelPart = keyof typeof PARTS;

const WHITE = new Color('white');

/**
 * A model with hatching materials: one set for the settings, copies for the compared technique from the first comparison on, and node
 * materials while WebGPURenderer draws the model.
 */
export class HatchedModel {
  /** Whether the model came with ambient occlusion, so that none needs to be baked. */
  isOccluded = false;
  /** Cameras, lights and variants of the file, in the space of the root. */
  extras: ModelExtras = NO_EXTRAS;
  /** The parts of the model; undefined if it is of one part. */
  parts: ModelParts | undefined;
  private readonly surfaces: readonly Surface[];
  private readonly meshes: readonly Mesh[];
  private readonly sets: { drawn: MaterialSet } & Partial<Record<MaterialKind, MaterialSet>>;
  /** What is drawn: a part of the model in a look, with the materials of one kind. */
  private readonly shown: { look: Look | undefined; part: ModelPart; outlines: boolean; kind: MaterialKind } = {
    look: undefined,
    part: 'whole',
    outlines: true,
    kind: 'drawn',
  };

  /**
   * @param root the model, centred, with a radius of 1. Its materials are hatching materials with the colours and maps of the source, and
   *   strokes of one tile per world unit.
   * @param bounds of the parts that stand on the ground
   * @param framedPoints xyz of points on the outer parts of the root, in all poses
   * @param stands the up axis suggested by what it stands on; undefined if there is none
   * @param motion clips and morph targets, if the model has any
   * @param outlines of its meshes; several may share a material
   * @param free called when the model is disposed
   */
  constructor(
    readonly root: Object3D,
    readonly bounds: Box3,
    readonly framedPoints: Float32Array,
    readonly stands: UpAxis | undefined,
    readonly statistics: ModelStatistics,
    readonly motion: Motion | undefined,
    materials: readonly HatchingMaterial[],
    outlines: readonly HatchingOutlines[],
    private readonly free: () => void,
  ) {
    this.surfaces = materials.map(surfaceOf);
    this.meshes = meshesOf(root);
    for (const mesh of this.meshes) mesh.castShadow = mesh.receiveShadow = !isGlass(mesh);
    this.sets = {
      drawn: setOf(
        materials,
        outlines,
        this.meshes.map(({ material }) => material),
      ),
    };
  }

  /** The parts, if they are joined to one mesh. */
  get joinedParts(): ModelParts | undefined {
    return this.parts?.hide ? undefined : this.parts;
  }

  /** The extent of the model, by which all parts of the scene measure depth. */
  get extent(): SceneExtent | null {
    return this.sets.drawn.materials[0]?.composition.extent ?? null;
  }

  /** Whether it has one-sided surfaces whose backs could be seen: those that cast shadows by their fronts. */
  get hidesBacks(): boolean {
    return this.sets.drawn.materials.some(({ shadowSide }) => shadowSide === FrontSide);
  }

  /**
   * Whether any geometry lacks triangle adjacency, so that techniques that need it cannot draw the model yet. Damaged meshes, which are
   * hidden, do not count.
   */
  get lacksAdjacency(): boolean {
    return this.meshes.some(({ visible, geometry }) => {
      const { layout } = (geometry.userData.hatching ?? {}) as Partial<HatchingStatistics>;
      return visible && layout !== 'corner' && layout !== 'pull';
    });
  }

  /** Shows the whole model in a look. While adjacency is missing, techniques that need it are drawn as `hatching`. */
  apply(look: Look): void {
    for (const _ of this.applying(look));
  }

  /** As {@link apply}, one material per step, because models may have thousands. Materials that have the look already are skipped. */
  *applying(asked: Look): Generator<void, void, void> {
    const { shown, sets, surfaces } = this;
    const look = this.lacksAdjacency ? withoutAdjacency(asked) : asked;
    if (!shown.look || materialKey(look) !== materialKey(shown.look)) {
      shown.look = undefined;
      if (look.compared) sets.compared ??= this.copies(this.drawnMaterials.map((material) => material.clone()));
      const setters = { drawn: parameterSetter(look.drawn), compared: parameterSetter(look.compared ?? look.drawn) };
      for (const [i, surface] of surfaces.entries()) {
        for (const [kind, { materials }] of this.kinds()) {
          setters[kind === 'compared' ? kind : 'drawn'](materials[i]);
          materials[i].tilesPerObjectUnit *= surface.scale;
          showSurface(materials[i], surface, look.showsSurfaceColors);
        }
        yield;
      }
      // A body without parts, such as a scan, may have loose pieces on its skin, whose lines would be specks.
      const outlines = { ...look.outlines, intersections: look.outlines.intersections && this.parts !== undefined };
      for (const [, { outlineMaterials }] of this.kinds())
        for (const material of outlineMaterials) material.setValues(outlines);
    }
    shown.look = look;
    this.show('whole');
  }

  /** Shows a part of the model, until a look is applied. @param hasOutlines whether outlines that the part has are drawn */
  show(part: ModelPart, hasOutlines = true): void {
    const { shown, surfaces } = this;
    const { paper, ink, shadows, outlines } = PARTS[part];
    const wasWhole = shown.part === 'whole' || shown.part === 'sketch';
    const isWhole = part === 'whole' || part === 'sketch';
    Object.assign(shown, { part, outlines: outlines && hasOutlines && shown.look?.showsOutlines !== false });
    for (const mesh of this.meshes) mesh.castShadow = shadows && !isGlass(mesh);
    this.showOutlines();
    if (wasWhole && isWhole) return;
    for (const kind of ['drawn', 'compared'] as const) {
      for (const [i, material] of (this.sets[kind]?.materials ?? []).entries()) {
        const { isGlass: isClear, blending, premultipliedAlpha } = surfaces[i];
        material.colorWrite = ink !== 'hidden';
        material.toneCurve = ink === 'blank' ? BLANK_CURVE : (shown.look?.[kind]?.toneCurve ?? material.toneCurve);
        material.paperOpacity = !paper ? 0 : isClear ? paperOfGlass(material.technique) : 1;
        // NoBlending makes a near surface overwrite strokes behind it, also in the gaps between its own strokes.
        material.blending = paper || isClear ? blending : NoBlending;
        material.premultipliedAlpha = paper || isClear ? premultipliedAlpha : true;
        if (ink === 'clear') Object.assign(material, NO_INK);
        material.needsUpdate = true;
      }
    }
  }

  set tonalArtMap(map: TonalArtMap) {
    for (const [, { materials }] of this.kinds()) for (const material of materials) material.tonalArtMap = map;
  }

  /**
   * Sets the widths of strokes and outlines.
   *
   * @param share of their full width, below 1 on small sheets
   * @param scale of a picture relative to the page
   */
  setWidths(look: Look, share: number, scale = 1): void {
    const sizes = materialSizesIn(look, share, scale);
    const outlineSizes = outlineSizesIn(look, share * scale);
    for (const [, { materials, outlineMaterials }] of this.kinds()) {
      for (const material of materials) Object.assign(material, sizes);
      for (const material of outlineMaterials) material.setValues(outlineSizes);
    }
  }

  /** Selects the materials for the next rendering. */
  useMaterials(kind: MaterialKind): void {
    const { sets, shown } = this;
    const { ofMeshes } = sets[kind] ?? sets.drawn;
    for (const [i, mesh] of this.meshes.entries()) mesh.material = ofMeshes[i];
    if (kind === shown.kind) return;
    shown.kind = kind;
    // Nodes that are merely hidden would make the other renderer build programs for them.
    for (const outlines of sets.nodes?.outlines ?? []) {
      if (kind === 'nodes') outlines.mesh?.add(outlines);
      else outlines.removeFromParent();
    }
    this.showOutlines();
  }

  /** Makes node materials with a look, if there are none. */
  makeNodes(makers: NodeMakers, look: Look): void {
    if (this.sets.nodes) return;
    const copies = new Map(
      [...this.sets.drawn.outlineMaterials].map((material) => [material, makers.outlineMaterial()]),
    );
    const outlines = this.sets.drawn.outlines.map(({ mesh, material }) => makers.outlines(mesh, copies.get(material)!));
    this.sets.nodes = this.copies(this.drawnMaterials.map(makers.material), outlines);
    this.shown.look = undefined;
    this.apply(look);
  }

  /** Resolves when the node materials have all their textures. */
  async nodesReady(): Promise<void> {
    await Promise.all(((this.sets.nodes?.materials ?? []) as HatchingNodeMaterial[]).map(({ ready }) => ready));
  }

  /** Frees the node materials, if there are any. */
  dropNodes(): void {
    this.useMaterials('drawn');
    const { materials = [], outlines = [] } = this.sets.nodes ?? {};
    for (const one of outlines) one.dispose();
    for (const one of [...materials, ...outlines.map(({ material }) => material)]) one.dispose();
    this.sets.nodes = undefined;
  }

  /** Tells the materials which geometries they will draw, so that a renderer's `compile` builds exactly those programs. */
  announce(): void {
    for (const mesh of this.meshes)
      for (const material of [mesh.material].flat()) (material as Partial<HatchingMaterial>).announce?.(mesh);
  }

  /** As the function {@link releaseGraphics}, including materials and pictures that no mesh shows at the moment. */
  releaseGraphics(): void {
    releaseGraphics(this.root);
    for (const kind of ['drawn', 'compared'] as const) this.sets[kind]?.materials.forEach(releaseMaterial);
    for (const { map } of this.surfaces) map?.dispose();
  }

  dispose(): void {
    this.dropNodes();
    for (const material of this.sets.compared?.materials ?? []) material.dispose();
    for (const { map } of this.surfaces) map?.dispose();
    this.free();
  }

  private get drawnMaterials(): readonly HatchingMaterial[] {
    return this.sets.drawn.materials as readonly HatchingMaterial[];
  }

  private kinds(): [MaterialKind, MaterialSet][] {
    return Object.entries(this.sets).filter(([, set]) => set) as [MaterialKind, MaterialSet][];
  }

  /** Copies of the drawn materials, with those of each mesh. Made on demand, because models may have thousands. */
  private copies(materials: readonly EitherMaterial[], outlines: MaterialSet['outlines'] = []): MaterialSet {
    const copies = new Map<Material, Material>(this.drawnMaterials.map((drawn, i) => [drawn, materials[i]]));
    const copyOf = (material: Material): Material => copies.get(material) ?? material;
    const ofMeshes = this.sets.drawn.ofMeshes.map((drawn) =>
      Array.isArray(drawn) ? drawn.map(copyOf) : copyOf(drawn),
    );
    return setOf(materials, outlines, ofMeshes);
  }

  private showOutlines(): void {
    const { sets, shown } = this;
    for (const outlines of sets.drawn.outlines) outlines.visible = shown.outlines && shown.kind !== 'nodes';
    for (const outlines of sets.nodes?.outlines ?? []) outlines.visible = shown.outlines;
  }
}

const setOf = (
  materials: MaterialSet['materials'],
  outlines: MaterialSet['outlines'],
  ofMeshes: MaterialSet['ofMeshes'],
): MaterialSet => ({
  materials,
  outlines,
  ofMeshes,
  outlineMaterials: new Set(outlines.map(({ material }) => material)),
});

/** A look with `hatching` in place of techniques that need triangle adjacency. */
function withoutAdjacency(look: Look): Look {
  const { drawn, compared } = look;
  const without = (parameters: HatchingMaterialParameters): HatchingMaterialParameters =>
    needsAdjacency(parameters)
      ? { ...parameters, technique: 'hatching', perTriangle: { ...parameters.perTriangle, sharpInk: false } }
      : parameters;
  return { ...look, drawn: without(drawn), compared: compared && without(compared) };
}

/** A key for the part of a look that concerns materials: equal keys give equal materials. */
const materialKey = ({ drawn, compared, outlines, showsSurfaceColors }: Look): string =>
  JSON.stringify([drawn, compared, outlines, showsSurfaceColors]);

function surfaceOf(material: HatchingMaterial): Surface {
  const {
    color,
    map,
    vertexColors,
    alphaTest,
    transparent: isGlass,
    metalness,
    blending,
    premultipliedAlpha,
  } = material;
  const scale = material.tilesPerObjectUnit;
  return {
    color: color.clone(),
    map,
    vertexColors,
    alphaTest,
    isGlass,
    metalness,
    blending,
    premultipliedAlpha,
    scale,
  };
}

/** Whether all materials of a mesh are see-through, so that it neither casts nor receives shadows. */
const isGlass = ({ material }: Mesh): boolean => [material].flat().every(({ transparent }) => transparent);

function showSurface(material: EitherMaterial, surface: Surface, isShown: boolean): void {
  material.color.multiply(isShown ? surface.color : WHITE);
  // Cut-outs such as leaves keep their map, whose alpha cuts them out.
  const map = isShown || surface.alphaTest > 0 ? surface.map : null;
  const vertexColors = isShown && surface.vertexColors;
  if (map !== material.map || vertexColors !== material.vertexColors) material.needsUpdate = true;
  material.map = map;
  material.vertexColors = vertexColors;
  material.alphaTest = map ? surface.alphaTest : 0;
  material.metalness = isShown ? surface.metalness : 0;
  if (surface.isGlass) Object.assign(material, GLASS, { paperOpacity: paperOfGlass(material.technique) });
}
