import { Layers, type Mesh } from 'three';

/** The layers of outlines: those of their mesh, also when these change later, unless others were set for the outlines themselves. */
export class MeshLayers extends Layers {
  declare mask: number;
  /** What was set for the outlines themselves; null while they follow the mesh. */
  private own: number | null = null;

  constructor(private readonly outlines: { readonly mesh: Mesh | null }) {
    super();
    const standard = this.mask;
    const followed = (): number => this.outlines.mesh?.layers.mask ?? standard;
    Object.defineProperty(this, 'mask', {
      get: () => this.own ?? followed(),
      set: (mask: number) => {
        // Whoever moves all objects of a scene to a layer moves the mesh too.
        this.own = mask === followed() ? null : mask;
      },
      enumerable: true,
    });
  }

  /** Follows a mesh, or has layers of its own, as others do. */
  copy(source: MeshLayers): void {
    this.own = source.own;
  }
}
