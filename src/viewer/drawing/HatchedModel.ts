import {
  type Blending,
  type Box3,
  Color,
  CustomBlending,
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
import { GLASS, needsAdjacency } from 'three-hatching/facts';
import type {
  HatchingNodeMaterial,
  HatchingOutlineNodeMaterial,
  HatchingOutlines as NodeOutlines,
} from 'three-hatching/webgpu';
import { type ModelExtras, NO_EXTRAS } from '../files/common/ModelExtras.js';
import type { UpAxis } from '../files/mesh/findUpAxis.js';
import type { Look } from '../settings/lookOf.js';
import type { Motion } from './Motion.js';
import type { EitherMaterial, NodeMakers } from './materials.js';
import { materialSizesIn, outlineSizesIn, parameterSetter } from './materials.js';
import { meshesOf } from './meshesOf.js';
import { releaseGraphics, releaseMaterial } from './releaseGraphics.js';

/** Blending that leaves the colour unchanged. The surface still writes depth. */
const NO_INK = { blending: CustomBlending, blendSrc: ZeroFactor, blendDst: OneFactor };

/** Statistics of the bake, summed over a model. */
export interface ModelStatistics {
  triangles: number;
  borderEdges: number;
  nonManifoldEdges: number;
  unpairedEdges: number;
  inconsistentEdges: number;
  degenerateTriangles: number;
}

/** The properties of a material that come from the model, not from the settings. */
interface Surface {
  color: Color;
  map: Texture | null;
  vertexColors: boolean;
  alphaTest: number;
  /** Whether the surface is see-through. */
  isGlass: boolean;
  blending: Blending;
  premultipliedAlpha: boolean;
}

/** A material of the model with its copies for other renderings. They share the model's surface. */
interface MaterialPair {
  drawn: HatchingMaterial;
  compared: HatchingMaterial | undefined;
  /** The node material, while WebGPURenderer draws the model. */
  nodes: HatchingNodeMaterial | undefined;
  surface: Surface;
  /** The stroke scale that gives one tile per world unit. */
  scale: number;
}

const WHITE = new Color('white');

/** A tone curve that draws no ink. */
export const BLANK: readonly (readonly [number, number])[] = [
  [0, 0],
  [1, 0],
];

/** Which materials a rendering uses: those of the settings, of the compared technique, or of nodes. */
export type MaterialKind = 'drawn' | 'compared' | 'nodes';

/**
 * A model with hatching materials: one set for the settings, copies for the compared technique from the first comparison on, and node
 * materials while WebGPURenderer draws the model.
 */
export class HatchedModel {
  /** Whether the model came with ambient occlusion, so that none needs to be baked. */
  isOccluded = false;
  /** Cameras, lights and variants of the file, in the space of the root. */
  extras: ModelExtras = NO_EXTRAS;
  private readonly pairs: readonly MaterialPair[];
  private readonly meshes: ({ mesh: Mesh } & Record<MaterialKind, Material | Material[]>)[];
  /** Key of the look that the materials have; undefined if they were changed since. */
  private shown: string | undefined;
  private readonly outlineMaterials: Set<HatchingOutlineMaterial | HatchingOutlineNodeMaterial>;
  /** Outlines for WebGPURenderer; undefined without node materials. */
  private nodeOutlines: readonly NodeOutlines[] | undefined;
  private used: MaterialKind = 'drawn';
  private areOutlinesShown = true;

  /**
   * @param root the model, centred, with a radius of 1. Its materials are hatching materials with the colours and maps of the source, and
   *   strokes of one tile per world unit.
   * @param bounds of the parts that stand on the ground
   * @param outline xyz of points on the outer parts of the root, in all poses
   * @param stands the up axis suggested by a flat side; undefined if there is none
   * @param motion clips and morph targets, if the model has any
   * @param outlines of its meshes; several may share a material
   * @param free called when the model is disposed
   */
  constructor(
    readonly root: Object3D,
    readonly bounds: Box3,
    readonly outline: Float32Array,
    readonly stands: UpAxis | undefined,
    readonly statistics: ModelStatistics,
    readonly motion: Motion | undefined,
    materials: readonly HatchingMaterial[],
    private readonly outlines: readonly HatchingOutlines[],
    private readonly free: () => void,
  ) {
    this.pairs = materials.map((drawn) => ({
      drawn,
      compared: undefined,
      nodes: undefined,
      surface: surfaceOf(drawn),
      scale: drawn.tilesPerUnit,
    }));
    this.meshes = meshesOf(root).map((mesh) => {
      mesh.castShadow = mesh.receiveShadow = !isGlass(mesh);
      const { material } = mesh;
      return { mesh, drawn: material, compared: material, nodes: material };
    });
    this.outlineMaterials = new Set(outlines.map(({ material }) => material));
  }

  /** The extent of the model, by which all parts of the scene measure depth. */
  get extent(): SceneExtent | null {
    return this.pairs[0]?.drawn.extent ?? null;
  }

  /**
   * Whether any geometry lacks triangle adjacency, so that techniques that need it cannot draw the model yet. Damaged meshes, which are
   * hidden, do not count.
   */
  get lacksAdjacency(): boolean {
    return this.meshes.some(({ mesh: { visible, geometry } }) => {
      const { layout } = (geometry.userData.hatching ?? {}) as Partial<HatchingStatistics>;
      return visible && layout !== 'corner' && layout !== 'pull';
    });
  }

  /** Applies a look to the materials. While adjacency is missing, techniques that need it are drawn as `anchored`. */
  apply(look: Look): void {
    for (const _ of this.applying(look));
  }

  /**
   * Applies a look step by step, one material per step, because models may have thousands. Materials that have the look already are
   * skipped.
   */
  *applying(asked: Look): Generator<void, void, void> {
    const look = this.lacksAdjacency ? withoutAdjacency(asked) : asked;
    const shown = materialKey(look);
    if (shown !== this.shown) {
      this.shown = undefined;
      if (look.compared) this.makeCopies();
      const setDrawn = parameterSetter(look.drawn);
      const setCompared = parameterSetter(look.compared ?? look.drawn);
      for (const pair of this.pairs) {
        const { drawn, compared, nodes, surface, scale } = pair;
        setDrawn(drawn);
        if (compared) setCompared(compared);
        if (nodes) setDrawn(nodes);
        for (const material of allOf(pair)) {
          material.tilesPerUnit *= scale;
          showSurface(material, surface, look.showsSurfaceColors);
        }
        yield;
      }
      for (const material of this.outlineMaterials) material.setValues(look.outlines);
      this.shown = shown;
    }
    this.showOutlines(look.showsOutlines);
    this.castShadows(true);
  }

  /** Sets whether the meshes cast shadows, until a look is applied again. */
  castShadows(areCast: boolean): void {
    for (const { mesh } of this.meshes) mesh.castShadow = areCast && !isGlass(mesh);
  }

  /** Shows or hides the outlines, until a look is applied again. */
  showOutlines(shown: boolean): void {
    this.areOutlinesShown = shown;
    for (const outlines of this.outlines) outlines.visible = shown && this.used !== 'nodes';
    for (const outlines of this.nodeOutlines ?? []) outlines.visible = shown;
  }

  set tonalArtMap(map: TonalArtMap) {
    for (const pair of this.pairs) for (const material of allOf(pair)) material.tonalArtMap = map;
  }

  /**
   * Sets the widths of strokes and outlines.
   *
   * @param share of their full width, below 1 on small sheets
   * @param scale of a picture relative to the page
   */
  setWidths(look: Look, share: number, scale = 1): void {
    const sizes = materialSizesIn(look, share, scale);
    for (const pair of this.pairs) for (const material of allOf(pair)) Object.assign(material, sizes);
    const outlineSizes = outlineSizesIn(look, share * scale);
    for (const material of this.outlineMaterials) material.setValues(outlineSizes);
  }

  /** Shows or hides the paper. Surfaces without paper still hide what is behind them. */
  showPaper(shown: boolean): void {
    this.shown = undefined;
    for (const pair of this.pairs) {
      const { surface } = pair;
      for (const material of bothOf(pair)) {
        if (surface.isGlass) continue;
        material.paperOpacity = shown ? 1 : 0;
        // NoBlending makes a near surface overwrite strokes behind it, also in the gaps between its own strokes.
        material.blending = shown ? surface.blending : NoBlending;
        material.premultipliedAlpha = shown ? surface.premultipliedAlpha : true;
        material.needsUpdate = true;
      }
    }
  }

  /**
   * Shows the model's part of one layer of a picture, which still hides what is behind the model; undefined shows all layers.
   *
   * @param layer `shadow` is the ground's layer, to which a model adds nothing
   */
  showLayer(layer: 'colour' | 'shadow' | 'strokes' | 'outline' | undefined, look: Look): void {
    this.apply(look);
    this.showPaper(layer === undefined || layer === 'colour');
    for (const pair of this.pairs) {
      for (const material of bothOf(pair)) {
        material.colorWrite = layer !== 'shadow';
        // Outlines are not drawn for a material with colorWrite: false.
        if (layer === 'outline') Object.assign(material, NO_INK);
        if (layer === 'colour') material.toneCurve = BLANK;
      }
    }
    if (layer === undefined) return;
    for (const outlines of this.outlines) outlines.visible &&= layer === 'outline';
  }

  /** Selects the materials for the next rendering. */
  useMaterials(kind: MaterialKind): void {
    for (const entry of this.meshes) entry.mesh.material = entry[kind];
    if (kind === this.used) return;
    this.used = kind;
    // Nodes that are merely hidden would make the other renderer build programs for them.
    for (const outlines of this.nodeOutlines ?? []) {
      if (kind === 'nodes') outlines.mesh?.add(outlines);
      else outlines.removeFromParent();
    }
    this.showOutlines(this.areOutlinesShown);
  }

  /** Makes node materials with a look, if there are none. */
  makeNodes(makers: NodeMakers, look: Look): void {
    if (this.nodeOutlines) return;
    for (const pair of this.pairs) pair.nodes = makers.material(pair.drawn);
    this.giveMaterials('nodes');
    const copies = new Map([...this.outlineMaterials].map((material) => [material, makers.outlineMaterial()]));
    this.nodeOutlines = this.outlines.map(({ mesh, material }) => makers.outlines(mesh, copies.get(material)!));
    for (const copy of copies.values()) this.outlineMaterials.add(copy);
    this.shown = undefined;
    this.apply(look);
  }

  /** Resolves when the node materials have all their textures. */
  async nodesReady(): Promise<void> {
    await Promise.all(this.pairs.map(({ nodes }) => nodes?.ready));
  }

  /** Frees the node materials, if there are any. */
  dropNodes(): void {
    this.useMaterials('drawn');
    for (const pair of this.pairs) {
      pair.nodes?.dispose();
      pair.nodes = undefined;
    }
    this.giveMaterials('nodes');
    for (const outlines of this.nodeOutlines ?? []) {
      outlines.dispose();
      outlines.material.dispose();
      this.outlineMaterials.delete(outlines.material);
    }
    this.nodeOutlines = undefined;
  }

  /** Tells the materials which geometries they will draw, so that a renderer's `compile` builds exactly those programs. */
  announce(): void {
    for (const { mesh } of this.meshes)
      for (const material of [mesh.material].flat()) (material as Partial<HatchingMaterial>).announce?.(mesh);
  }

  /** As the function {@link releaseGraphics}, including materials and pictures that no mesh shows at the moment. */
  releaseGraphics(): void {
    releaseGraphics(this.root);
    for (const pair of this.pairs) {
      for (const material of bothOf(pair)) releaseMaterial(material);
      pair.surface.map?.dispose();
    }
  }

  dispose(): void {
    this.dropNodes();
    for (const { compared, surface } of this.pairs) {
      compared?.dispose();
      surface.map?.dispose();
    }
    this.free();
  }

  /** Copies the materials for a comparison. Made only on demand, because models may have thousands of materials. */
  private makeCopies(): void {
    if (this.pairs.every(({ compared }) => compared)) return;
    for (const pair of this.pairs) pair.compared = pair.drawn.clone();
    this.giveMaterials('compared');
  }

  /** Assigns the materials of a kind to the meshes, for as many pairs as have one. */
  private giveMaterials(kind: 'compared' | 'nodes'): void {
    const copies = new Map<Material, Material | undefined>(this.pairs.map((pair) => [pair.drawn, pair[kind]]));
    const copyOf = (material: Material): Material => copies.get(material) ?? material;
    for (const entry of this.meshes) {
      const { drawn } = entry;
      entry[kind] = Array.isArray(drawn) ? drawn.map(copyOf) : copyOf(drawn);
    }
  }
}

/** A look with `anchored` in place of techniques that need triangle adjacency. */
function withoutAdjacency(look: Look): Look {
  const { drawn, compared } = look;
  const without = (parameters: HatchingMaterialParameters): HatchingMaterialParameters =>
    needsAdjacency(parameters) ? { ...parameters, technique: 'anchored', crisp: false } : parameters;
  return { ...look, drawn: without(drawn), compared: compared && without(compared) };
}

/** A key for the part of a look that concerns materials: equal keys give equal materials. */
const materialKey = ({ drawn, compared, outlines, showsSurfaceColors }: Look): string =>
  JSON.stringify([drawn, compared, outlines, showsSurfaceColors]);

/** The drawn material, and its copy for comparison if there is one. */
const bothOf = ({ drawn, compared }: MaterialPair): HatchingMaterial[] => (compared ? [drawn, compared] : [drawn]);

/** As {@link bothOf}, plus the node material if there is one. */
const allOf = (pair: MaterialPair): EitherMaterial[] => (pair.nodes ? [...bothOf(pair), pair.nodes] : bothOf(pair));

function surfaceOf(material: HatchingMaterial): Surface {
  const { color, map, vertexColors, alphaTest, transparent, blending, premultipliedAlpha } = material;
  return {
    color: color.clone(),
    map,
    vertexColors,
    alphaTest,
    isGlass: transparent,
    blending,
    premultipliedAlpha,
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
  if (surface.isGlass) Object.assign(material, GLASS);
}
