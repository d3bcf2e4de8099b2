import type { Camera, Scene, ShadowMapType } from 'three';

/** Who draws: materials in GLSL on WebGLRenderer, or of nodes on WebGPURenderer, with its WebGL 2 backend or with WebGPU. */
export type Drawn = 'glsl' | 'forceWebGL' | 'webgpu';

/** Makes what a scene is drawn with, for who draws it. */
export interface Kit {
  readonly drawn: Drawn;
  /** Of two materials or objects that say the same, the one in GLSL or the one of nodes. */
  either<Glsl, Nodes>(glsl: () => Glsl, nodes: () => Nodes): Glsl | Nodes;
}

/** What is drawn. Each drawer gets a scene of its own. */
export interface Stage {
  scene: Scene;
  camera: Camera;
  /** Changes the scene after a first frame. What is compared is drawn then. */
  change?(): void;
}

/** A scene that is drawn in GLSL and of nodes. */
export interface SceneCase {
  name: string;
  show(kit: Kit): Stage | Promise<Stage>;
  /** The filter of shadows. Default: none are drawn. */
  shadows?: ShadowMapType;
  /**
   * What WebGPU is held to: as many pixels alike as `forceWebGL`, or the same mean tone, where edges are as wide as derivatives on
   * the screen say, which WebGPU takes of other pixels. Default: `pixels`.
   */
  onWebGPU?: 'pixels' | 'tone';
}
