import {
  type BufferAttribute,
  BufferGeometry,
  ClampToEdgeWrapping,
  Float32BufferAttribute,
  type InterleavedBufferAttribute,
  type Mesh,
  type MeshStandardMaterial,
  MirroredRepeatWrapping,
  type Texture,
  Vector2,
  Vector3,
} from 'three';
import { readImage, type TextureImage } from '../material/readImage.js';
import type { OldLook } from './geometryPlans.js';
import { isBatched } from './surfaceMeshes.js';

/** The displacement properties of three's surface materials. */
type Displacing = Pick<MeshStandardMaterial, 'displacementMap' | 'displacementScale' | 'displacementBias'>;
type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Heights as a function of texture coordinates. */
type Heights = (uv: Vector2) => number;

/** Makes geometries with the heights of displacement maps applied to their vertices, as three.js draws them; each once. */
export class Displacer {
  private readonly made = new Map<string, BufferGeometry>();
  private readonly images = new Map<Texture, TextureImage | null>();

  /**
   * The geometry of a mesh with every vertex moved along its normal. It has no normals: the bake computes them from the displaced
   * surface.
   *
   * @throws Error if a map cannot be read here, or has no coordinates
   */
  displaced({ mesh, geometry, oldMaterial: material }: OldLook): BufferGeometry {
    if (isBatched(mesh))
      throw new Error(
        'applyHatching: its displacementMap would move all geometries of the batch. Displace them before.',
      );
    const key = [geometry, ...[material].flat()].map((one) => one?.uuid).join();
    let displaced = this.made.get(key);
    if (!displaced) {
      displaced = this.displace(geometry, material);
      this.made.set(key, displaced);
    }
    return displaced;
  }

  private displace(geometry: BufferGeometry, material: Mesh['material']): BufferGeometry {
    const displaced = new BufferGeometry().copy(geometry);
    if (!displaced.getAttribute('normal')) displaced.computeVertexNormals();
    const { position, normal } = displaced.attributes;
    const places = new Float32BufferAttribute(3 * position.count, 3);
    const isMoved = new Uint8Array(position.count);
    const [place, direction, coordinates] = [new Vector3(), new Vector3(), new Vector2()];
    for (let vertex = 0; vertex < position.count; vertex++)
      places.setXYZ(vertex, position.getX(vertex), position.getY(vertex), position.getZ(vertex));
    const corners = displaced.index?.count ?? position.count;
    const groups = Array.isArray(material) ? displaced.groups : [{ start: 0, count: corners, materialIndex: 0 }];
    for (const { start, count, materialIndex = 0 } of groups) {
      const of = [material].flat()[materialIndex] as Partial<Displacing> | undefined;
      if (!of?.displacementMap) continue;
      const uv = displaced.getAttribute(coordinatesOf(of.displacementMap)) as Attribute | undefined;
      if (!uv)
        throw new Error('applyHatching: its displacementMap has no texture coordinates. Add them to the geometry.');
      const heights = this.heightsOf(of.displacementMap);
      for (let corner = start; corner < Math.min(start + count, corners); corner++) {
        const vertex = displaced.index?.getX(corner) ?? corner;
        if (vertex >= position.count || isMoved[vertex] === 1) continue;
        isMoved[vertex] = 1;
        const height = heights(coordinates.fromBufferAttribute(uv as BufferAttribute, vertex));
        direction.fromBufferAttribute(normal as BufferAttribute, vertex).normalize();
        place.fromBufferAttribute(position as BufferAttribute, vertex);
        place.addScaledVector(direction, (of.displacementScale ?? 1) * height + (of.displacementBias ?? 0));
        places.setXYZ(vertex, place.x, place.y, place.z);
      }
    }
    displaced.setAttribute('position', places);
    displaced.deleteAttribute('normal');
    displaced.boundingBox = displaced.boundingSphere = null;
    displaced.userData = {};
    return displaced;
  }

  private heightsOf(texture: Texture): Heights {
    if (!this.images.has(texture)) this.images.set(texture, readImage(texture));
    const image = this.images.get(texture);
    if (!image)
      throw new Error(
        'applyHatching: the pixels of its displacementMap cannot be read here. Load the picture before, from a site that allows it; or displace the geometry.',
      );
    if (texture.matrixAutoUpdate) texture.updateMatrix();
    return (uv) => heightAt(image, texture, uv.applyMatrix3(texture.matrix));
  }
}

const coordinatesOf = ({ channel }: Texture): string => (channel === 0 ? 'uv' : `uv${channel}`);

/** The red channel of an image, interpolated between its pixels. */
function heightAt({ width, height, data }: TextureImage, { wrapS, wrapT }: Texture, { x, y }: Vector2): number {
  const [across, up] = [x * width - 0.5, y * height - 0.5];
  const [left, below] = [Math.floor(across), Math.floor(up)];
  const at = (column: number, row: number): number =>
    data[4 * (wrapped(row, height, wrapT) * width + wrapped(column, width, wrapS))];
  const [s, t] = [across - left, up - below];
  const low = (1 - s) * at(left, below) + s * at(left + 1, below);
  const high = (1 - s) * at(left, below + 1) + s * at(left + 1, below + 1);
  return (1 - t) * low + t * high;
}

/** The pixel index that a texture's wrapping maps an index beyond the edge to. */
function wrapped(pixel: number, size: number, wrapping: Texture['wrapS']): number {
  if (wrapping === ClampToEdgeWrapping) return Math.min(Math.max(pixel, 0), size - 1);
  const along = ((pixel % (2 * size)) + 2 * size) % (2 * size);
  return wrapping === MirroredRepeatWrapping && along >= size ? 2 * size - 1 - along : along % size;
}
