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
import { luminanceOf, type Vec3 } from '../../look/vectors.js';
import type { ToneFit } from '../../material/exposure/ToneFit.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import { mapBlurOf } from '../../material/hatchingUniforms.js';
import { isSharp, readImage } from '../../material/readImage.js';
import {
  type MapLook,
  type PaintLook,
  TONE_MAPS,
  type ToneImage,
  type ToneMap,
  type Wrapping,
} from '../paint/PaintLook.js';
import type { Mat3 } from '../shading/screenGradient.js';
import { colorTonesOf } from './colorTones.js';
import type { MeshCopy } from './meshCopies.js';
import { rowsOf } from './surfaceFrame.js';

/** The properties of colours and textures of a material; materials that are not hatched have only some of them. */
export type Painted = Material & {
  [name in ToneMap]?: Texture | null;
} & { color?: Color };

/** The attributes that the paint of a surface needs: channels of texture coordinates, and vertex colours. */
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

/** Alpha above which blended materials are drawn. */
const HALF = 0.5;

/** Reads the textures and colours of surfaces. Each image is read once. */
export class PaintReader {
  private readonly images = new Map<Texture, ToneImage | null>();

  /** @param fit fit of the exposure to the scene */
  constructor(private readonly fit: ToneFit) {}

  /** Textures that affect tone, but whose pixels cannot be read. */
  unreadable(material: Painted): ToneMap[] {
    return TONE_MAPS.filter((name) => material[name] && this.counts(material, name) && !this.imageOf(material[name]));
  }

  /** The attributes that the paint of a mesh needs; null if the mesh has one colour everywhere. */
  needs(mesh: Mesh, material: Painted, { tint }: MeshCopy): PaintNeeds | null {
    const maps = TONE_MAPS.filter((name) => this.mapOf(mesh, material, name));
    const hasColors = this.heedsColor(material) && (tint !== null || hasVertexColors(mesh, material));
    if (maps.length === 0 && !hasColors) return null;
    const channels = new Set(maps.map((name) => material[name]!.channel));
    return { channels: [...channels].sort(), hasColors };
  }

  /** The paint of a surface. Its details have texture coordinates from `first` on, channel by channel, and then colours. */
  paint({ mesh, copy, material }: PaintedPart, { channels, hasColors }: PaintNeeds, first: number): PaintLook {
    const look = (name: ToneMap): MapLook | null => {
      const texture = this.mapOf(mesh, material, name);
      return texture && this.look(texture, first + 2 * channels.indexOf(texture.channel));
    };
    const hatched = 'isHatchingMaterial' in material ? (material as HatchingMaterial) : null;
    const { emissive, emissiveIntensity = 0 } = hatched ?? {};
    return {
      color: material.color ? (material.color.toArray() as unknown as Vec3) : [1, 1, 1],
      opacity: isBlended(material) ? 1 : material.opacity,
      emissive: emissive ? (emissive.toArray().map((x) => x * emissiveIntensity) as unknown as Vec3) : [0, 0, 0],
      tones: colorTonesOf(hatched, this.fit),
      mapBlur: hatched ? mapBlurOf(hatched, 1, 1) : 0,
      vertexColor: hasColors ? first + 2 * channels.length : null,
      ...(Object.fromEntries(TONE_MAPS.map((name) => [name, look(name)])) as Record<ToneMap, MapLook | null>),
      normalToWorld: hatched?.normalMapType === ObjectSpaceNormalMap ? normalsToWorld(copy) : null,
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

  /** A texture that affects tone, has coordinates and can be read. */
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

  /** Whether the colour or the alpha of a surface has any effect. */
  private heedsColor(material: Painted): boolean {
    return (
      alphaTestOf(material) > 0 ||
      ('isHatchingMaterial' in material && (material as HatchingMaterial).colorHatching > 0)
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

/** Whether a material is blended by its textures' alpha. Lines cannot fade so: it is drawn where alpha is above a half. */
export const isBlended = ({ transparent, alphaTest, alphaHash, map, alphaMap }: Painted): boolean =>
  (transparent || alphaHash) && alphaTest === 0 && Boolean(map ?? alphaMap);

/** Alpha below which nothing of a surface is drawn; 0 for none. */
export function alphaTestOf(material: Painted): number {
  if (material.alphaTest > 0) return material.alphaTest;
  return isBlended(material) ? HALF : 0;
}

/** Whether a map modifies the normals that tone is computed from. It does not with flat faces, and a normal map replaces a bump map. */
const bendsNormals = (
  { normalMap, toneNormal, flatShading }: HatchingMaterial,
  name: 'normalMap' | 'bumpMap',
): boolean => (name === 'normalMap' || normalMap === null) && toneNormal !== 'face' && !flatShading;

/** three.js has one normal matrix for a whole mesh that deforms: that at rest. */
const normalsToWorld = ({ toWorld }: MeshCopy): Mat3 => rowsOf(new Matrix3().getNormalMatrix(toWorld));

export const coordinatesOf = (channel: number): string => (channel === 0 ? 'uv' : `uv${channel}`);

const hasVertexColors = ({ geometry }: Mesh, { vertexColors }: Material): boolean =>
  vertexColors && geometry.attributes.color !== undefined;

function wrappingOf(wrapping: number): Wrapping {
  if (wrapping === RepeatWrapping) return 'repeat';
  return wrapping === MirroredRepeatWrapping ? 'mirror' : 'clamp';
}

/** Writes the colour of a vertex, times that of an instance; alpha is 1 for colours of three numbers. */
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
