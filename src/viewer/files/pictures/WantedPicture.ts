import type { Texture } from 'three';

/** A picture that a merged mesh asks for. */
export interface WantedPicture {
  /** Its image is a {@link PictureLink}. */
  texture: Texture;
  /**
   * A picture of its own whose lightness is the alpha of the other, or its darkness where `userData.isInverted` says so; its image is a
   * {@link PictureLink}, too.
   */
  mask?: Texture | undefined;
  /** The alpha below which nothing of the surface is there; 0 if all is. */
  cutOut: number;
  /** Whether the surface is blended: one whose picture is half there is seen through instead. */
  isBlended?: boolean;
}

/** What a texture holds in place of its picture: where the picture lies. */
export interface PictureLink {
  url: string;
  /** The picture itself, if it is a part of the model. */
  content?: Blob | undefined;
  width: number;
  height: number;
}
