import type { Texture } from 'three';

/** A picture needed by a merged mesh. */
export interface WantedPicture {
  /** Its image is a {@link PictureLink}. */
  texture: Texture;
  /** A separate alpha map: lightness is alpha, or darkness where `userData.isInverted` is set. Its image is a {@link PictureLink}, too. */
  mask?: Texture | undefined;
  /** The alpha below which the surface is cut out; 0 without a cut-out. */
  cutOut: number;
  /** Whether the surface is blended; if its picture is mostly half-transparent, it becomes see-through. */
  isBlended?: boolean;
}

/** The image of a texture before loading: the location of the picture. */
export interface PictureLink {
  url: string;
  /** The picture itself, if it is embedded in the model. */
  content?: Blob | undefined;
  width: number;
  height: number;
}
