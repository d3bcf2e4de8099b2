import {
  Camera,
  GLSL3,
  Mesh,
  NearestFilter,
  PlaneGeometry,
  RawShaderMaterial,
  Scene,
  type Vector2Tuple,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { TonalArtMap } from 'three-hatching';

/** The sampling of the map: at an explicit level, or with the level that follows from the coordinates, as in a material. */
type Sampling = 'explicitLevel' | 'automaticLevel';

interface Sample {
  sampling: Sampling;
  layer: number;
  /** Explicit level of detail. */
  level: number;
  /** Texture coordinates advance by 1 over so many pixels. */
  pixelsPerTile: number;
  /** Added to the texture coordinates, in tiles. */
  offset: Vector2Tuple;
  /** Pixels per side of the target. */
  size: number;
}

const renderer = new WebGLRenderer({ antialias: false });
const camera = new Camera();

const vertexShader = /* glsl */ `
in vec3 position;
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }
`;

const fragmentShader = (sampling: Sampling) => /* glsl */ `
precision highp float;
precision highp sampler2DArray;
uniform sampler2DArray map;
uniform float layer;
uniform float level;
uniform float pixelsPerTile;
uniform vec2 offset;
out vec4 color;
void main() {
  vec3 place = vec3(gl_FragCoord.xy / pixelsPerTile + offset, layer);
  color = ${sampling === 'explicitLevel' ? 'textureLod(map, place, level)' : 'texture(map, place)'};
}
`;

/** RGBA bytes of a square target into which the map was sampled, row 0 at the lowest v. */
function sample(map: TonalArtMap, values: Partial<Sample>): Uint8Array {
  const all: Sample = {
    sampling: 'explicitLevel',
    layer: 0,
    level: 0,
    pixelsPerTile: map.size,
    offset: [0, 0],
    size: map.size,
    ...values,
  };
  const target = new WebGLRenderTarget(all.size, all.size, {
    depthBuffer: false,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
  });
  const material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader: fragmentShader(all.sampling),
    uniforms: {
      map: { value: map.texture },
      layer: { value: all.layer },
      level: { value: all.level },
      pixelsPerTile: { value: all.pixelsPerTile },
      offset: { value: all.offset },
    },
    depthTest: false,
    toneMapped: false,
  });
  const geometry = new PlaneGeometry(2, 2);
  const scene = new Scene();
  scene.add(new Mesh(geometry, material));
  const bytes = new Uint8Array(4 * all.size * all.size);
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  renderer.readRenderTargetPixels(target, 0, 0, all.size, all.size, bytes);
  renderer.setRenderTarget(null);
  geometry.dispose();
  material.dispose();
  target.dispose();
  return bytes;
}

/** A byte that only image (tone, level) has. */
const byteOf = (tone: number, level: number): number => 250 - 40 * tone - 7 * level;

/** Every image one grey of its own: `byteOf`. Averaging finer levels cannot give a coarser one. */
function constantMap(size: number, tones: number, levels: number): TonalArtMap {
  const images = Array.from({ length: tones }, (_, tone) =>
    Array.from({ length: levels }, (_, level) => new Uint8Array((size >> level) ** 2).fill(byteOf(tone, level))),
  );
  return TonalArtMap.fromHatchImages({ size, images });
}

/** The four bytes of a target that has one colour, or null. */
function singleColor(bytes: Uint8Array): number[] | null {
  return bytes.every((byte, i) => byte === bytes[i % 4]) ? [...bytes.subarray(0, 4)] : null;
}

const tonalArtMapTests = {
  /** [tone group][level] as sampled at explicit levels, then halfway between levels. */
  constants() {
    const map = constantMap(16, 6, 4);
    const at = (layer: number, level: number) => singleColor(sample(map, { layer, level }));
    const levels = [0, 1, 2, 3, 0.5, 2.5];
    const result = [0, 1].map((layer) => levels.map((level) => at(layer, level)));
    map.dispose();
    return result;
  },

  /** Texels per pixel 1, 2, 4, 8, without an explicit level. */
  automatic() {
    const map = constantMap(16, 4, 4);
    const result = [1, 2, 4, 8].map((texelsPerPixel) =>
      singleColor(sample(map, { sampling: 'automaticLevel', pixelsPerTile: 16 / texelsPerPixel })),
    );
    map.dispose();
    return result;
  },

  /** A map without levels, far away. */
  singleLevel() {
    const map = constantMap(16, 4, 1);
    const result = singleColor(sample(map, { sampling: 'automaticLevel', pixelsPerTile: 2 }));
    map.dispose();
    return result;
  },

  /** Images of a generated map whose bytes on the GPU differ from `.image()`, as [tone, level]; and how many were compared. */
  async generated() {
    const map = await TonalArtMap.generate({ style: 'crossHatching', size: 64, tones: 6, seed: 4 });
    const different: [number, number][] = [];
    let compared = 0;
    for (let tone = 0; tone < map.tones; tone++) {
      for (let level = 0; level < map.levels; level++) {
        const image = map.image(tone, level);
        const size = map.size >> level;
        for (let layer = 0; layer < Math.ceil((map.tones - 1) / 3); layer++) {
          const channel = tone - 3 * layer;
          if (channel < 0 || channel > 3) continue;
          // A tile further: the map repeats both ways.
          const bytes = sample(map, { layer, level, pixelsPerTile: size, size, offset: [3, -2] });
          if (image.some((byte, i) => byte !== bytes[4 * i + channel])) different.push([tone, level]);
          compared++;
        }
      }
    }
    map.dispose();
    return { different, compared };
  },

  /** Calls that upload texels while two materials draw the same map twice; then the textures left after dispose. */
  uploads() {
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const upload = gl.texSubImage3D;
    let calls = 0;
    gl.texSubImage3D = (...args: unknown[]) => {
      calls++;
      Reflect.apply(upload, gl, args);
    };
    const before = renderer.info.memory.textures;
    const map = constantMap(16, 8, 5);
    for (let i = 0; i < 4; i++) sample(map, { level: i });
    const during = renderer.info.memory.textures - before;
    map.dispose();
    gl.texSubImage3D = upload;
    return { calls, during, after: renderer.info.memory.textures - before };
  },

  /** Rejections of a drawing in the worker: aborted while it runs, and asked for nonsense. */
  async refusals() {
    const controller = new AbortController();
    const progress: number[] = [];
    const aborted = await TonalArtMap.generate({
      size: 1024,
      tones: 16,
      signal: controller.signal,
      onProgress: (value) => {
        progress.push(value);
        controller.abort();
      },
    }).then(
      () => 'drawn',
      (reason: Error) => reason.name,
    );
    const nonsense = await TonalArtMap.generate({ tones: 1000 }).then(
      () => 'drawn',
      (reason: Error) => reason.message,
    );
    return { aborted, reports: progress.length, nonsense };
  },
};

export type TonalArtMapTests = typeof tonalArtMapTests;

declare global {
  interface Window {
    tonalArtMapTests?: TonalArtMapTests;
  }
}

window.tonalArtMapTests = tonalArtMapTests;
