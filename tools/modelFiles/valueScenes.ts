import { PNG } from 'pngjs';
import {
  BoxGeometry,
  type BufferGeometry,
  CapsuleGeometry,
  ConeGeometry,
  CylinderGeometry,
  IcosahedronGeometry,
  SphereGeometry,
  TorusGeometry,
} from 'three';
import { GltfBuilder } from './GltfBuilder.js';

/** Scenes of many materials as people find them, as glTF: what a plan of values has to sort. */

/** A material: sRGB as 0xrrggbb, and what glTF says beside it. */
interface Paint {
  color: number;
  metal?: number;
  rough?: number;
  alpha?: number;
  /** An image of its own, by rows from the top, each pixel 0xrrggbb. */
  image?: { width: number; height: number; at: (column: number, row: number) => number };
}

interface Part {
  shape: BufferGeometry;
  at: readonly [number, number, number];
  /** Turns about x, y and z, in quarters. */
  turned?: readonly [number, number, number];
  paint: Paint;
}

const box = (x: number, y: number, z: number): BufferGeometry => new BoxGeometry(x, y, z);
const ball = (radius: number): BufferGeometry => new SphereGeometry(radius, 24, 16);
const tube = (top: number, bottom: number, height: number): BufferGeometry =>
  new CylinderGeometry(top, bottom, height, 24);

const WHITE = { color: 0xf2f2f0 };
const RUBBER = { color: 0x151515, rough: 0.9 };
const GLASS = { color: 0x10161c, rough: 0.05, metal: 0.2 };
const CHROME = { color: 0xc8ccd0, metal: 1, rough: 0.15 };

function car(): Part[] {
  const red = { color: 0x8a1014, rough: 0.3 };
  const dark = { color: 0x26282c, rough: 0.5 };
  const parts: Part[] = [
    { shape: box(4, 0.6, 1.7), at: [0, 0.6, 0], paint: red },
    { shape: box(2, 0.55, 1.5), at: [-0.2, 1.15, 0], paint: GLASS },
    { shape: box(1.7, 0.08, 1.45), at: [-0.2, 1.46, 0], paint: red },
    { shape: box(1, 0.06, 1.5), at: [1.4, 0.92, 0], paint: { color: 0x7a0e12, rough: 0.3 } },
    { shape: box(0.1, 0.2, 1.2), at: [2.02, 0.6, 0], paint: dark },
    { shape: box(0.12, 0.12, 1.7), at: [2, 0.35, 0], paint: CHROME },
    { shape: box(0.12, 0.12, 1.7), at: [-2, 0.35, 0], paint: CHROME },
  ];
  for (const x of [-1.3, 1.3])
    for (const z of [-0.8, 0.8]) {
      parts.push({ shape: tube(0.38, 0.38, 0.25), at: [x, 0.38, z], turned: [1, 0, 0], paint: RUBBER });
      parts.push({ shape: tube(0.22, 0.22, 0.27), at: [x, 0.38, z], turned: [1, 0, 0], paint: CHROME });
    }
  for (const z of [-0.6, 0.6]) {
    parts.push({ shape: ball(0.13), at: [1.98, 0.72, z], paint: { color: 0xf5f2d8 } });
    parts.push({ shape: box(0.05, 0.12, 0.3), at: [-2.01, 0.75, z], paint: { color: 0xc01018 } });
  }
  // Many small parts in tints of their own.
  for (let i = 0; i < 24; i++)
    parts.push({
      shape: box(0.12, 0.05, 0.05),
      at: [-1.8 + 0.15 * i, 0.32, 0.87],
      paint: { color: 0x202020 + 0x050505 * i },
    });
  return parts;
}

function helicopter(): Part[] {
  const olive = { color: 0x3c4028 };
  const parts: Part[] = [
    { shape: new CapsuleGeometry(0.7, 1.4, 8, 24), at: [0, 1.2, 0], turned: [0, 0, 1], paint: olive },
    { shape: ball(0.62), at: [0.95, 1.25, 0], paint: GLASS },
    { shape: tube(0.12, 0.3, 2.6), at: [-2.2, 1.4, 0], turned: [0, 0, 1], paint: { color: 0x343822 } },
    { shape: box(0.5, 0.8, 0.08), at: [-3.4, 1.8, 0], paint: { color: 0x2c301c } },
    { shape: tube(0.1, 0.1, 0.6), at: [0, 2.1, 0], paint: { color: 0x404448 } },
    { shape: box(5.4, 0.04, 0.2), at: [0, 2.4, 0], paint: { color: 0x1c1e20 } },
    { shape: box(0.2, 0.04, 5.4), at: [0, 2.42, 0], paint: { color: 0x1c1e20 } },
    { shape: box(0.5, 0.5, 0.02), at: [-0.4, 1.2, 0.72], paint: { color: 0xd8d4c0 } },
  ];
  for (const z of [-0.6, 0.6]) {
    parts.push({ shape: tube(0.06, 0.06, 2.6), at: [0, 0.3, z], turned: [0, 0, 1], paint: { color: 0x24262a } });
    for (const x of [-0.6, 0.6])
      parts.push({ shape: tube(0.05, 0.05, 0.6), at: [x, 0.5, 0.8 * z], paint: { color: 0x24262a } });
  }
  return parts;
}

function apartment(): Part[] {
  const wood = { color: 0x5a3a22 };
  return [
    { shape: box(6, 0.1, 5), at: [0, 0, 0], paint: { color: 0x8a6a48 } },
    { shape: box(6, 2.4, 0.1), at: [0, 1.2, -2.5], paint: { color: 0xd8d2c4 } },
    { shape: box(0.1, 2.4, 5), at: [-3, 1.2, 0], paint: { color: 0xcfc8ba } },
    { shape: box(2.2, 0.4, 0.9), at: [-1.5, 0.35, -1.8], paint: { color: 0x30343c } },
    { shape: box(2.2, 0.5, 0.25), at: [-1.5, 0.75, -2.2], paint: { color: 0x282c34 } },
    { shape: box(1.4, 0.06, 0.8), at: [-1.4, 0.45, -0.6], paint: wood },
    { shape: box(1.6, 0.5, 2), at: [1.8, 0.3, -1.2], paint: { color: 0xe8e4e0 } },
    { shape: box(1.6, 0.1, 1.4), at: [1.8, 0.6, -0.9], paint: { color: 0x1e3a5a } },
    { shape: box(0.9, 2, 0.5), at: [-2.6, 1, 1.6], turned: [0, 1, 0], paint: wood },
    { shape: box(1.4, 0.9, 0.05), at: [0.4, 1.5, -2.42], paint: { color: 0x0c0c10, rough: 0.1 } },
    { shape: tube(0.25, 0.35, 0.4), at: [2.7, 1.2, 1.6], paint: { color: 0xf0e0b0 } },
    { shape: tube(0.03, 0.03, 1), at: [2.7, 0.6, 1.6], paint: { color: 0x202020 } },
    { shape: box(2.4, 0.02, 1.6), at: [-1.4, 0.06, -0.6], paint: { color: 0x7a2a2a } },
  ];
}

function garden(): Part[] {
  const parts: Part[] = [
    { shape: box(8, 0.2, 6), at: [0, -0.1, 0], paint: { color: 0x4a6a28 } },
    { shape: tube(1.3, 1.3, 0.06), at: [1.6, 0.03, 1], paint: { color: 0x0c1c24, rough: 0.05 } },
    { shape: box(2, 1.4, 1.6), at: [-2, 0.7, -1.4], paint: { color: 0xe4ddc8 } },
    { shape: new ConeGeometry(1.7, 1, 4), at: [-2, 1.9, -1.4], paint: { color: 0x5c2418 } },
  ];
  for (let i = 0; i < 60; i++) {
    const angle = (2 * Math.PI * i) / 60;
    parts.push({
      shape: new IcosahedronGeometry(0.09, 1),
      at: [1.6 + 1.45 * Math.cos(angle), 0.05, 1 + 1.45 * Math.sin(angle)],
      paint: { color: 0x505050 + 0x010101 * ((i * 37) % 60) },
    });
  }
  for (const [x, z, size] of [
    [2.6, -1.8, 1],
    [0.6, -2, 0.7],
    [-3.2, 1.6, 0.6],
  ]) {
    parts.push({ shape: tube(0.1, 0.14, size), at: [x, size / 2, z], paint: { color: 0x3a2818 } });
    parts.push({ shape: new IcosahedronGeometry(0.7 * size, 2), at: [x, 1.5 * size, z], paint: { color: 0x2c5420 } });
  }
  return parts;
}

function street(): Part[] {
  const parts: Part[] = [{ shape: box(10, 0.1, 3), at: [0, -0.05, 0], paint: { color: 0x2c2c30 } }];
  const walls = [0xb08868, 0xc8b8a0, 0x8a4a3a, 0x9aa4a8];
  for (let i = 0; i < 4; i++) {
    const height = 2 + ((i * 7) % 3) * 0.5;
    parts.push({ shape: box(2.2, height, 1.6), at: [-3.6 + 2.4 * i, height / 2, -2.3], paint: { color: walls[i] } });
    for (let k = 0; k < 6; k++)
      parts.push({
        shape: box(0.4, 0.5, 0.06),
        at: [-4.2 + 2.4 * i + 0.6 * (k % 3), 0.8 + 0.9 * Math.floor(k / 3), -1.5],
        paint: GLASS,
      });
  }
  for (let i = 0; i < 12; i++) {
    const [x, z] = [-4.4 + 0.8 * i, 0.9 - 0.5 * (i % 3)];
    parts.push({ shape: box(0.25, 0.4, 0.18), at: [x, 0.35, z], paint: { color: 0x40505c } });
    parts.push({ shape: ball(0.11), at: [x, 0.66, z], paint: { color: 0x8898a0, metal: 0.8, rough: 0.3 } });
    parts.push({ shape: box(0.2, 0.15, 0.14), at: [x, 0.08, z], paint: { color: 0x181a1e } });
  }
  return parts;
}

/** Stripes of blue and green of the lightness of the light grey between them. */
function figure(): Part[] {
  const stripes = [0xbcbcbc, 0x89c1f7, 0xbcbcbc, 0x7ccd7c];
  const image = { width: 128, height: 256, at: (_: number, row: number) => stripes[Math.floor(row / 32) % 4] };
  return [
    { shape: tube(0.4, 0.6, 1.8), at: [0, 0.95, 0], paint: { color: 0xffffff, image } },
    { shape: ball(0.38), at: [0, 2.25, 0], paint: { color: 0xbcbcbc } },
  ];
}

/** Skin, a shirt with a badge, trousers, and a cloth of fine checks, in one texture. */
function character(): Part[] {
  const at = (column: number, row: number): number => {
    if (row < 48) return 0xc89878;
    if (row < 120) {
      if (column > 0 && column < 32 && row > 64 && row < 96) return column > 8 && column < 24 ? 0xd02018 : 0xf4f0e0;
      return (column + row) % 2 ? 0x2a4a3a : 0x3a6a50;
    }
    return row < 200 ? 0x2c3040 : 0x20140c;
  };
  const image = { width: 128, height: 256, at };
  return [
    { shape: tube(0.5, 0.6, 2.6), at: [0, 1.3, 0], paint: { color: 0xffffff, image } },
    { shape: ball(0.16), at: [0.62, 1.8, 0], paint: { color: 0xc89878 } },
    { shape: ball(0.16), at: [-0.62, 1.8, 0], paint: { color: 0xc89878 } },
  ];
}

/** Panels on a roof, which are dark and bright by turns as the sky is. */
function panels(): Part[] {
  const parts: Part[] = [
    { shape: box(4, 1.6, 3), at: [0, 0.8, 0], paint: WHITE },
    { shape: box(4.4, 0.15, 3.4), at: [0, 1.7, 0], paint: { color: 0x9a5a40 } },
    { shape: box(0.8, 1.2, 0.05), at: [-1, 0.6, 1.52], paint: { color: 0x503820 } },
    { shape: box(1, 0.7, 0.05), at: [0.9, 0.9, 1.52], paint: GLASS },
  ];
  for (let i = 0; i < 6; i++)
    parts.push({
      shape: box(1.1, 0.06, 1.2),
      at: [-1.3 + 1.25 * (i % 3), 1.84, -0.7 + 1.35 * Math.floor(i / 3)],
      paint: { color: 0x0a1430, rough: 0.1, metal: 0.4 },
    });
  return parts;
}

/** A motor of bare metals. */
function motor(): Part[] {
  const parts: Part[] = [
    { shape: tube(0.8, 0.8, 1.6), at: [0, 1, 0], turned: [0, 0, 1], paint: CHROME },
    { shape: box(2.2, 0.3, 1.4), at: [0, 0.15, 0], paint: { color: 0x50565c, metal: 1, rough: 0.4 } },
    {
      shape: new TorusGeometry(0.6, 0.12, 12, 32),
      at: [1, 1, 0],
      turned: [0, 1, 0],
      paint: { color: 0xb07a30, metal: 1, rough: 0.25 },
    },
    { shape: tube(0.15, 0.15, 1.2), at: [1.4, 1, 0], turned: [0, 0, 1], paint: CHROME },
  ];
  for (let i = 0; i < 7; i++)
    parts.push({
      shape: tube(0.95, 0.95, 0.06),
      at: [-0.6 + 0.2 * i, 1, 0],
      turned: [0, 0, 1],
      paint: { color: 0x3a3e44, metal: 1, rough: 0.5 },
    });
  return parts;
}

const SCENES = { car, helicopter, apartment, garden, street, figure, character, panels, motor };

/** The scenes as GLB, by name. */
export const valueScenes = (): Record<string, Uint8Array> =>
  Object.fromEntries(Object.entries(SCENES).map(([name, parts]) => [name, glbOf(parts())]));

function glbOf(parts: readonly Part[]): Uint8Array {
  const builder = new GltfBuilder();
  const { json } = builder;
  json.materials = parts.map(({ paint }) => materialOf(builder, paint));
  json.meshes = parts.map(({ shape }, material) => {
    const { position, normal, uv } = shape.attributes;
    const attributes = {
      POSITION: builder.accessor(new Float32Array(position.array), 'VEC3'),
      NORMAL: builder.accessor(new Float32Array(normal.array), 'VEC3'),
      TEXCOORD_0: builder.accessor(
        Float32Array.from(uv.array, (value, i) => (i % 2 ? 1 - value : value)),
        'VEC2',
      ),
    };
    const indices = shape.index ? { indices: builder.accessor(new Uint32Array(shape.index.array), 'SCALAR') } : {};
    return { primitives: [{ attributes, ...indices, material }] };
  });
  json.nodes = [
    { children: parts.map((_, i) => i + 1) },
    ...parts.map(({ at, turned = [0, 0, 0] }, mesh) => ({ mesh, translation: at, rotation: quaternion(turned) })),
  ];
  return builder.glb();
}

function materialOf(builder: GltfBuilder, { color, metal = 0, rough = 0.8, alpha = 1, image }: Paint): object {
  const { json } = builder;
  const linear = [16, 8, 0].map((shift) => (((color >> shift) & 255) / 255) ** 2.2);
  const pbr: Record<string, unknown> = {
    baseColorFactor: [...linear, alpha],
    metallicFactor: metal,
    roughnessFactor: rough,
  };
  if (image) {
    const png = new PNG({ width: image.width, height: image.height });
    for (let i = 0; i < image.width * image.height; i++) {
      const pixel = image.at(i % image.width, Math.floor(i / image.width));
      png.data.set([pixel >> 16, (pixel >> 8) & 255, pixel & 255, 255], 4 * i);
    }
    json.images = [...(json.images ?? []), { bufferView: builder.view(PNG.sync.write(png)), mimeType: 'image/png' }];
    json.textures = [...(json.textures ?? []), { source: json.images.length - 1 }];
    pbr.baseColorTexture = { index: json.textures.length - 1 };
  }
  return { pbrMetallicRoughness: pbr, ...(alpha < 1 && { alphaMode: 'BLEND' }) };
}

/** A quaternion of quarter turns about one axis at most. */
function quaternion(quarters: readonly [number, number, number]): number[] {
  const half = quarters.map((quarter) => Math.sin((quarter * Math.PI) / 4));
  return [...half, Math.cos((Math.max(...quarters) * Math.PI) / 4)];
}
