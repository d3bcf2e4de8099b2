import { ImageLoader } from 'three';

/** What a texture holds in place of its picture: where the picture lies. */
export interface PictureLink {
  url: string;
  width: number;
  height: number;
}

/**
 * Runs one of three's loaders so that it loads no picture: every texture gets a {@link PictureLink}. Loaders make pictures with a
 * document, which a worker does not have, and would fetch what nobody dropped.
 *
 * @param parse must not wait for anything
 */
export function withPictureLinks<Result>(parse: () => Result): Result {
  const loader = ImageLoader.prototype as { load: unknown };
  const { load } = loader;
  loader.load = (url: string, onLoad?: (picture: PictureLink) => void): PictureLink => {
    const link = { url, width: 1, height: 1 };
    onLoad?.(link);
    return link;
  };
  try {
    return parse();
  } finally {
    loader.load = load;
  }
}
