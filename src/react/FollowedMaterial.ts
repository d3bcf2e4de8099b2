import { invalidate } from '@react-three/fiber';
import { HatchingMaterial } from 'three-hatching';

/** The material of `<hatchingMaterial>`: asks for a frame when its map is ready, for a canvas that draws only when something changes. */
export class FollowedMaterial extends HatchingMaterial {
  /** What was drawn last: the map, and the version of the program, which says whether it needs one. */
  private followed: { readonly map: unknown; readonly version: number } | undefined;

  // The part of HatchingMaterial runs before this, as before any hook that is set in its place.
  override onBeforeRender(): void {
    const { tonalArtMap: map, version } = this;
    if (this.followed?.map === map && this.followed.version === version) return;
    this.followed = { map, version };
    // A map that cannot be drawn is told of by the library.
    this.ready.then(() => invalidate()).catch(() => {});
  }
}
