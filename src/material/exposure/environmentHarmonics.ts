import { type CubeTexture, type Texture, Vector3 } from 'three';
import type { Harmonics } from '../../look/surroundings.js';
import { type PixelColors, pixelColors } from './pixelColors.js';

/** The greatest number of rows of an image that are sampled, and of columns. */
const MAX_ROWS = 128;
/** Used for an environment that cannot be read because it is on the GPU only: `RoomEnvironment` of three.js, as measured. */
const ROOM = /* @__PURE__ */ Float64Array.of(3.71, 1.7, 1.56, 0.25, 0.1, 0.78, 1.17, -0.32, -0.69);

const known = new WeakMap<Texture, { version: number; harmonics: Harmonics }>();

/** The light of an environment as spherical harmonics. It is computed once per version of the texture. */
export function harmonicsOf(texture: Texture): Harmonics {
  const before = known.get(texture);
  if (before?.version === texture.version) return before.harmonics;
  const harmonics = project(texture) ?? ROOM;
  known.set(texture, { version: texture.version, harmonics });
  return harmonics;
}

const direction = /* @__PURE__ */ new Vector3();

/**
 * The directions to places (s, t) on the faces of a cube, in the order and with the axes of OpenGL: for each of x, y and z a number, and
 * the factors on s and t.
 */
const CUBE_FACES = [
  [1, 0, 0, 0, 0, -1, 0, -1, 0],
  [-1, 0, 0, 0, 0, -1, 0, 1, 0],
  [0, 1, 0, 1, 0, 0, 0, 0, 1],
  [0, 1, 0, -1, 0, 0, 0, 0, -1],
  [0, 1, 0, 0, 0, -1, 1, 0, 0],
  [0, -1, 0, 0, 0, -1, -1, 0, 0],
];

function project(texture: Texture): Harmonics | undefined {
  const sums = new Float64Array(10);
  if ('isCubeTexture' in texture) {
    const faces: unknown = (texture as CubeTexture).images;
    if (!Array.isArray(faces) || faces.length !== 6) return undefined;
    // three.js mirrors cube textures of images, but not those of render targets.
    const mirror = texture.isRenderTargetTexture ? 1 : -1;
    for (const [face, image] of faces.entries()) {
      const pixels = pixelColors(image, texture);
      if (!pixels) return undefined;
      addImage(sums, pixels, (s, t) => {
        const [a, b] = [2 * s - 1, 2 * t - 1];
        const f = CUBE_FACES[face];
        direction.set(f[0] + f[1] * a + f[2] * b, f[3] + f[4] * a + f[5] * b, f[6] + f[7] * a + f[8] * b);
        const size = direction.lengthSq();
        direction.x *= mirror;
        direction.normalize();
        return size ** -1.5;
      });
    }
  } else {
    const pixels = pixelColors(texture.image, texture);
    if (!pixels || texture.isRenderTargetTexture) return undefined;
    addImage(sums, pixels, (s, t) => {
      const height = Math.PI * (texture.flipY ? 0.5 - t : t - 0.5);
      const around = 2 * Math.PI * (s - 0.5);
      direction.set(Math.cos(height) * Math.cos(around), Math.sin(height), Math.cos(height) * Math.sin(around));
      return Math.cos(height);
    });
  }
  return sums[9] > 0 ? sums.subarray(0, 9).map((sum) => (4 * Math.PI * sum) / sums[9]) : undefined;
}

/**
 * Adds an image to the coefficients. @param place writes the direction of a place in the image, and returns the solid angle of a pixel
 * there
 */
function addImage(
  sums: Float64Array,
  { width, height, at }: PixelColors,
  place: (s: number, t: number) => number,
): void {
  const down = Math.max(1, Math.ceil(height / MAX_ROWS));
  const along = Math.max(1, Math.ceil(width / (2 * MAX_ROWS)));
  for (let row = 0; row < height; row += down) {
    for (let column = 0; column < width; column += along) {
      const size = place((column + along / 2) / width, (row + down / 2) / height);
      const light = size * (0.2126 * at(column, row, 0) + 0.7152 * at(column, row, 1) + 0.0722 * at(column, row, 2));
      if (!(light < Infinity)) continue;
      const { x, y, z } = direction;
      const basis = [
        0.282095,
        ...[0.488603 * y, 0.488603 * z, 0.488603 * x],
        ...[1.092548 * x * y, 1.092548 * y * z, 0.315392 * (3 * z * z - 1)],
        ...[1.092548 * x * z, 0.546274 * (x * x - y * y)],
      ];
      for (let i = 0; i < 9; i++) sums[i] += light * basis[i];
      sums[9] += size;
    }
  }
}
