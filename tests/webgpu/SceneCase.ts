import type { Camera, Material, Scene, ShadowMapType } from 'three';
import type { Node } from 'three/webgpu';
import type { HatchingMaterialParameters, HatchingShadowMaterialParameters } from 'three-hatching';

/** GLSL on WebGLRenderer, or nodes on WebGPURenderer with its WebGL 2 backend or with WebGPU. */
export type Drawn = 'glsl' | 'forceWebGL' | 'webgpu';

export type Depth = 'plain' | 'logarithmic' | 'reversed';

/** Makes materials and objects for one of the drawers. */
export interface Kit {
  readonly drawn: Drawn;
  /** `HatchingMaterial` or `HatchingNodeMaterial`, ready to draw. */
  hatching(parameters: HatchingMaterialParameters): Promise<Material>;
  /** `HatchingShadowMaterial` or `HatchingShadowNodeMaterial`, ready to draw. */
  shadows(parameters: HatchingShadowMaterialParameters): Promise<Material>;
  /** Chooses between two equal materials or objects: in GLSL, or of nodes. */
  either<Glsl, Nodes>(glsl: () => Glsl, nodes: () => Nodes): Glsl | Nodes;
}

/** A scene to draw. Each drawer gets its own. */
export interface Stage {
  scene: Scene;
  camera: Camera;
  /** A render pass around the scene, for nodes. Default: none. */
  through?(scene: Scene, camera: Camera): Node;
  /** Changes the scene after a first frame. The second frame is compared. */
  change?(): void | Promise<void>;
}

/** A scene that is drawn in GLSL and of nodes. */
export interface SceneCase {
  name: string;
  show(kit: Kit): Stage | Promise<Stage>;
  /** The filter of shadows. Default: no shadows. */
  shadows?: ShadowMapType;
  /** The depth buffer. Default: that of the device. */
  depth?: Depth;
  /**
   * The comparison with WebGPU: of pixels, or only of the mean tone where edges are as wide as screen-space derivatives, which WebGPU takes
   * from other pixels. Default: `pixels`.
   */
  onWebGPU?: 'pixels' | 'tone';
  /**
   * The largest share of pixels that may differ noticeably. Default: 0.0005. At the edges of shadows three's own materials differ in 0.0006
   * of all pixels, since its filters do.
   */
  most?: number;
}
