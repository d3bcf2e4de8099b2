import {
  type BufferAttribute,
  type Color,
  type Material,
  Matrix3,
  type Mesh,
  MirroredRepeatWrapping,
  ObjectSpaceNormalMap,
  RepeatWrapping,
  type Texture,
} from 'three';
import { luminanceOf } from '../../look/luminance.js';
import type { Vec3 } from '../../look/vectors.js';
import { isFitted } from '../../material/exposure/isFitted.js';
import type { ToneFit } from '../../material/exposure/ToneFit.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import { isSharp, readImage } from '../../material/readImage.js';
import type { MapLook, PaintLook, ToneImage, Wrapping } from '../paint/PaintLook.js';
import type { Mat3 } from '../shading/screenGradient.js';
import type { MeshCopy } from './pose/meshCopies.js';
import { rowsOf } from './rowsOf.js';

/** What a material says of colours and textures; of materials that are not hatched only some of it. */
export type Painted = Material & {
  [name in ToneMap]?: Texture | null;
} & { color?: Color };

/** What the paint of a surface reads of vertices: the channels of texture coordinates, and whether their colours count. */
export interface PaintNeeds {
  channels: readonly number[];
  hasColors: boolean;
}

/** A part of a mesh at one of its places. */
interface PaintedPart {
  mesh: Mesh;
  copy: MeshCopy;
  material: Painted;
}

/** The textures that count for the tone. */
const TONE_MAPS = ['map', 'emissiveMap', 'aoMap', 'lightMap', 'alphaMap', 'normalMap', 'bumpMap'] as const;
export type ToneMap = (typeof TONE_MAPS)[number];

/** From where on what is half transparent is drawn, of materials that are blended. */
const HALF = 0.5;

/** Reads what of a surface differs from place to place: textures and colours. Each image is read once. */
export class PaintReader {
  private readonly images = new Map<Texture, ToneImage | null>();

  /** @param fit of the exposure to the scene */
  constructor(private readonly fit: ToneFit) {}

  /** Textures that count for the tone, but whose pixels cannot be read. */
  unreadable(material: Painted): ToneMap[] {
    return TONE_MAPS.filter((name) => material[name] && this.counts(material, name) && !this.imageOf(material[name]));
  }

  /** What the paint of a mesh needs; null if nothing of it differs from place to place. */
  needs(mesh: Mesh, material: Painted, { tint }: MeshCopy): PaintNeeds | null {
    const maps = TONE_MAPS.filter((name) => this.mapOf(mesh, material, name));
    const hasColors = this.heedsColor(material) && (tint !== null || hasVertexColors(mesh, material));
    if (maps.length === 0 && !hasColors) return null;
    const channels = new Set(maps.map((name) => material[name]!.channel));
    return { channels: [...channels].sort(), hasColors };
  }

  /** The paint of a surface whose details begin with its coordinates at `first`, channel by channel, and go on with colours. */
  paint({ mesh, copy, material }: PaintedPart, { channels, hasColors }: PaintNeeds, first: number): PaintLook {
    const look = (name: ToneMap): MapLook | null => {
      const texture = this.mapOf(mesh, material, name);
      return texture && this.look(texture, first + 2 * channels.indexOf(texture.channel));
    };
    const hatched = 'isHatchingMaterial' in material ? (material as HatchingMaterial) : null;
    const { emissive, emissiveIntensity = 0, localTone = 0 } = hatched ?? {};
    return {
      color: material.color ? (material.color.toArray() as unknown as Vec3) : [1, 1, 1],
      opacity: isBlended(material) ? 1 : material.opacity,
      emissive: emissive ? (emissive.toArray().map((x) => x * emissiveIntensity) as unknown as Vec3) : [0, 0, 0],
      localTone,
      colorExposure: hatched && isFitted(hatched) ? 1 / this.fit.white : 1,
      vertexColor: hasColors ? first + 2 * channels.length : null,
      ...{ map: look('map'), emissiveMap: look('emissiveMap'), aoMap: look('aoMap') },
      ...{ lightMap: look('lightMap'), alphaMap: look('alphaMap') },
      normalMap: look('normalMap'),
      normalToWorld: hatched?.normalMapType === ObjectSpaceNormalMap ? normalsToWorld(copy) : null,
      bumpMap: look('bumpMap'),
      bumpScale: hatched?.bumpScale ?? 1,
      normalScale: hatched ? [hatched.normalScale.x, hatched.normalScale.y] : [1, 1],
      aoMapIntensity: hatched?.aoMapIntensity ?? 0,
      lightMapIntensity: hatched?.lightMapIntensity ?? 0,
      alphaTest: alphaTestOf(material),
    };
  }

  private look(texture: Texture, uv: number): MapLook {
    if (texture.matrixAutoUpdate) texture.updateMatrix();
    const e = texture.matrix.elements;
    return {
      image: this.imageOf(texture)!,
      uv,
      transform: [e[0], e[3], e[6], e[1], e[4], e[7]],
      wrapU: wrappingOf(texture.wrapS),
      wrapV: wrappingOf(texture.wrapT),
      isSharp: isSharp(texture),
    };
  }

  /** A texture that counts, has coordinates and can be read. */
  private mapOf({ geometry }: Mesh, material: Painted, name: ToneMap): Texture | null {
    const texture = material[name];
    if (!texture || !this.counts(material, name)) return null;
    return geometry.attributes[coordinatesOf(texture.channel)] && this.imageOf(texture) ? texture : null;
  }

  private counts(material: Painted, name: ToneMap): boolean {
    if (name === 'alphaMap') return alphaTestOf(material) > 0;
    if (name === 'map') return this.heedsColor(material);
    if (!('isHatchingMaterial' in material)) return false;
    if (name === 'normalMap' || name === 'bumpMap') return bendsNormals(material as HatchingMaterial, name);
    const { emissive, emissiveIntensity } = material as HatchingMaterial;
    return name !== 'emissiveMap' || emissiveIntensity * luminanceOf(emissive) > 0;
  }

  /** Whether the colour of a surface, or its alpha, makes a difference. */
  private heedsColor(material: Painted): boolean {
    return (
      alphaTestOf(material) > 0 || ('isHatchingMaterial' in material && (material as HatchingMaterial).localTone > 0)
    );
  }

  private imageOf(texture: Texture): ToneImage | null {
    let image = this.images.get(texture);
    if (image === undefined) {
      image = readImage(texture);
      this.images.set(texture, image);
    }
    return image;
  }
}

/** Whether alpha of its textures fades a material, which lines cannot: it is drawn where it is more than half there. */
export const isBlended = ({ transparent, alphaTest, alphaHash, map, alphaMap }: Painted): boolean =>
  (transparent || alphaHash) && alphaTest === 0 && Boolean(map ?? alphaMap);

/** Alpha below which nothing of a surface is there; 0 where none is cut out. */
export function alphaTestOf(material: Painted): number {
  if (material.alphaTest > 0) return material.alphaTest;
  return isBlended(material) ? HALF : 0;
}

/** Whether a map bends the normals that tone is computed from. Those of flat faces stay as they are, and a map of normals takes the place of heights. */
export const bendsNormals = (
  { normalMap, toneNormal, flatShading }: HatchingMaterial,
  name: 'normalMap' | 'bumpMap',
): boolean => (name === 'normalMap' || normalMap === null) && toneNormal !== 'face' && !flatShading;

/** three.js knows one map of normals for a whole mesh that deforms: that of its rest. */
const normalsToWorld = ({ toWorld }: MeshCopy): Mat3 => rowsOf(new Matrix3().getNormalMatrix(toWorld));

export const coordinatesOf = (channel: number): string => (channel === 0 ? 'uv' : `uv${channel}`);

export const hasVertexColors = ({ geometry }: Mesh, { vertexColors }: Material): boolean =>
  vertexColors && geometry.attributes.color !== undefined;

function wrappingOf(wrapping: number): Wrapping {
  if (wrapping === RepeatWrapping) return 'repeat';
  return wrapping === MirroredRepeatWrapping ? 'mirror' : 'clamp';
}

/** Reads the colour of a vertex, times that of an instance; alpha is 1 where colours have three numbers. */
export function writeColor(
  mesh: Mesh,
  material: Material,
  { tint }: MeshCopy,
  vertex: number,
  into: Float64Array,
  offset: number,
): void {
  const color = hasVertexColors(mesh, material) ? (mesh.geometry.attributes.color as BufferAttribute) : null;
  for (let k = 0; k < 3; k++) into[offset + k] = (color ? color.getComponent(vertex, k) : 1) * (tint?.[k] ?? 1);
  into[offset + 3] = color && color.itemSize === 4 ? color.getComponent(vertex, 3) : 1;
}
