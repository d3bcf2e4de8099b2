import { MAX_SIDE } from '../tamImages/mapLimits.js';
import { decodePng, type Pixels } from './decodePng.js';

/** Reads a file by its name. Error messages continue a sentence that begins with the name. */
export type ReadFile = (name: string) => Promise<Uint8Array>;

/** A grey picture. */
export interface GreyPicture {
  width: number;
  height: number;
  /** width·height bytes, top row first, 255 = paper. */
  image: Uint8Array;
}

/**
 * Reads the pictures of a map. All files are fetched at once. They are decoded one at a time, on request, since decoding may take 250 MB:
 * after a picture of a wrong size, no other is requested.
 */
export class PictureReader {
  private readonly files = new Map<string, Promise<Uint8Array>>();
  private readonly greys = new Map<string, GreyPicture>();
  private opened = 0;

  /**
   * @param names the names of all pictures, in the order in which they will be requested; names may repeat
   * @param onProgress called with the share of `names` that were requested so far
   */
  constructor(
    private readonly names: readonly string[],
    read: ReadFile,
    private readonly onProgress: (done: number) => void,
  ) {
    for (const name of new Set(names)) {
      const file = withFileName(name, read(name));
      // Errors are reported when the picture is requested, which does not happen after another has failed.
      file.catch(() => {});
      this.files.set(name, file);
    }
  }

  /** Opens a picture and makes it grey. A second call with the same name returns the same picture. */
  async grey(name: string): Promise<GreyPicture> {
    let grey = this.greys.get(name);
    if (!grey) {
      grey = greyOf(await this.decode(name));
      this.greys.set(name, grey);
    }
    this.count();
    return grey;
  }

  /** Opens a picture with its colours. */
  async colours(name: string): Promise<Pixels> {
    const pixels = await this.decode(name);
    this.count();
    return pixels;
  }

  private async decode(name: string): Promise<Pixels> {
    return withFileName(name, decodePng(await this.files.get(name)!, MAX_SIDE));
  }

  private count(): void {
    this.onProgress(++this.opened / this.names.length);
  }
}

/** The luminance of each pixel, computed from the bytes without linearising them. */
function greyOf({ width, height, channels, data }: Pixels): GreyPicture {
  if (channels === 1) return { width, height, image: data };
  const image = new Uint8Array(data.length / 3);
  for (let i = 0; i < image.length; i++) {
    image[i] = Math.round(0.2126 * data[3 * i] + 0.7152 * data[3 * i + 1] + 0.0722 * data[3 * i + 2]);
  }
  return { width, height, image };
}

/** @throws Error that names a file, its fault and the remedy */
export function fail(name: string, fault: string): never {
  throw new Error(`TonalArtMap.load: ${name} ${fault}.`);
}

/** Waits for work on a file, and prefixes errors with the name of the file. */
export async function withFileName<Result>(name: string, work: Promise<Result>): Promise<Result> {
  try {
    return await work;
  } catch (error) {
    fail(name, error instanceof Error ? error.message : String(error));
  }
}
