import { ClampToEdgeWrapping, type Material, MirroredRepeatWrapping, type Texture } from 'three';
import { baseName } from '../common/fileName.js';
import type { PictureLink } from '../pictures/WantedPicture.js';

interface Json {
  images?: object[];
  textures?: object[];
  samplers?: object[];
}

/** The members of three's exporter that are used here. */
interface Writer {
  json: Json;
  extensionsUsed: Record<string, boolean>;
}

const WRAPPINGS: Readonly<Record<number, number>> = { [ClampToEdgeWrapping]: 33071, [MirroredRepeatWrapping]: 33648 };
const REPEAT = 10497;
const TRANSFORM = 'KHR_texture_transform';

/** Writes the pictures of materials into glTF as URIs. three's exporter would need their pixels, which are not decoded yet. */
export class GltfPictureWriter {
  /** Embedded pictures, by URI. */
  readonly written = new Map<string, Blob>();
  private readonly maps = new Map<Material, Texture>();
  private readonly indices = new Map<string, number>();

  /** Sets the map of a material that has none. */
  use(material: Material, map: Texture): void {
    this.maps.set(material, map);
  }

  /** The plugin that three's exporter calls for each material. */
  plugin({ json, extensionsUsed }: Writer): object {
    return {
      name: 'pictures',
      writeMaterialAsync: async (material: Material, definition: { pbrMetallicRoughness: object }) => {
        const map = this.maps.get(material);
        if (!map) return;
        extensionsUsed[TRANSFORM] = true;
        const index = this.textureOf(map, json);
        Object.assign(definition.pbrMetallicRoughness, {
          baseColorTexture: { index, extensions: { [TRANSFORM]: transformOf(map) } },
        });
      },
    };
  }

  private textureOf(map: Texture, json: Json): number {
    json.images ??= [];
    json.textures ??= [];
    json.samplers ??= [];
    const source = this.imageOf(map.image as PictureLink, json.images);
    const wraps = [map.wrapS, map.wrapT].map((wrap) => WRAPPINGS[wrap] ?? REPEAT);
    const sampler = json.samplers.push({ wrapS: wraps[0], wrapT: wraps[1] }) - 1;
    return json.textures.push({ source, sampler }) - 1;
  }

  private imageOf({ url, content }: PictureLink, images: object[]): number {
    const known = this.indices.get(url);
    if (known !== undefined) return known;
    const uri = content
      ? `picture-${images.length}`
      : url.startsWith('data:')
        ? url
        : baseName(url).replaceAll('%', '%25');
    if (content) this.written.set(uri, content);
    const index = images.push({ uri }) - 1;
    this.indices.set(url, index);
    return index;
  }
}

/** Turns the picture over: pictures in glTF begin at the top, those of most loaders at the bottom. */
function transformOf({ offset, repeat, flipY }: Texture): object {
  return flipY
    ? { offset: [offset.x, 1 - offset.y], scale: [repeat.x, -repeat.y] }
    : { offset: [offset.x, offset.y], scale: [repeat.x, repeat.y] };
}
