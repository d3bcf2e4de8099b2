import type { Camera, Material, Scene, ShadowMapType } from 'three';
import type { Node } from 'three/webgpu';
import type { HatchingMaterialParameters } from 'three-hatching';

/** Who draws: materials in GLSL on WebGLRenderer, or of nodes on WebGPURenderer, with its WebGL 2 backend or with WebGPU. */
export type Drawn = 'glsl' | 'forceWebGL' | 'webgpu';

export type Depth = 'plain' | 'logarithmic' | 'reversed';

/** Makes what a scene is drawn with, for who draws it. */
export interface Kit {
  readonly drawn: Drawn;
  /** `HatchingMaterial` or `HatchingNodeMaterial`, ready to draw. */
  hatching(parameters: HatchingMaterialParameters): Promise<Material>;
  /** Of two materials or objects that say the same, the one in GLSL or the one of nodes. */
  either<Glsl, Nodes>(glsl: () => Glsl, nodes: () => Nodes): Glsl | Nodes;
}

/** What is drawn. Each drawer gets a scene of its own. */
export interface Stage {
  scene: Scene;
  camera: Camera;
  /** What nodes draw the scene through: a pass of the renderer, which may make more of it than a picture. Default: none. */
  through?(scene: Scene, camera: Camera): Node;
  /** Changes the scene after a first frame. What is compared is drawn then. */
  change?(): void;
}

/** A scene that is drawn in GLSL and of nodes. */
export interface SceneCase {
  name: string;
  show(kit: Kit): Stage | Promise<Stage>;
  /** The filter of shadows. Default: none are drawn. */
  shadows?: ShadowMapType;
  /** How depths are kept. Default: as a device keeps them. */
  depth?: Depth;
  /**
   * What WebGPU is held to: as many pixels alike as `forceWebGL`, or the same mean tone, where edges are as wide as derivatives on
   * the screen say, which WebGPU takes of other pixels. Default: `pixels`.
   */
  onWebGPU?: 'pixels' | 'tone';
  /**
   * The largest share of pixels that may be seen to differ. Default: 0.0005. Edges of the shadows of three's own materials are more: its
   * filters differ there, in 0.0006 of all pixels.
   */
  most?: number;
}
