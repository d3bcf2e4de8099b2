import { invalidate } from '@react-three/fiber';
import { HatchingMaterial } from 'three-hatching';

/**
 * The material of `<hatchingMaterial>`: asks for a frame when its map and its code are there, for a canvas that draws only when something
 * changes.
 */
export class FollowedMaterial extends HatchingMaterial {
  /** What was drawn last: what decides which map and which code are needed. */
  private followed: Partial<Pick<HatchingMaterial, 'tonalArtMap' | 'technique' | 'medium' | 'version'>> = {};

  // The part of HatchingMaterial runs before this, as before any hook that is set in its place.
  override onBeforeRender(): void {
    const { followed } = this;
    const isSame =
      followed.tonalArtMap === this.tonalArtMap &&
      followed.technique === this.technique &&
      followed.medium === this.medium &&
      followed.version === this.version;
    if (isSame) return;
    const { tonalArtMap, technique, medium, version } = this;
    this.followed = { tonalArtMap, technique, medium, version };
    // A map that cannot be drawn, and code that cannot be fetched, are told of by the library.
    this.ready.then(() => invalidate()).catch(() => {});
  }
}
