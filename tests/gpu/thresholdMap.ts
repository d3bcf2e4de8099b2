import {
  Camera,
  FloatType,
  GLSL3,
  Mesh,
  NearestFilter,
  PlaneGeometry,
  RawShaderMaterial,
  RedFormat,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { TonalArtMap } from 'three-hatching';
import thresholdMapChunk from '../../shaders/chunks/thresholdMap.glsl?raw';
import { normalQuantile } from '../../src/strokes/tamImages/thresholds.js';

const renderer = new WebGLRenderer({ antialias: false });
const camera = new Camera();

/**
 * g as the material's own chunk reads it, at the texel centres of a level or shifted by a part of a texel, so many octaves
 * above the finest level.
 */
function sample(map: TonalArtMap, level: number, shift = 0, octaves = level): Float32Array {
  const size = map.size >> level;
  const { width, height } = map.thresholdTexture.image;
  const target = new WebGLRenderTarget(size, size, {
    depthBuffer: false,
    format: RedFormat,
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
  });
  const material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: 'in vec3 position; void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }',
    fragmentShader: /* glsl */ `
      precision highp float;
      precision highp sampler2D;
      ${thresholdMapChunk}
      uniform float size, octaves, shift;
      out vec4 value;
      // A tile further: the map repeats both ways.
      void main() { value = vec4(thresholdAt((gl_FragCoord.xy + shift) / size + vec2(2.0, -1.0), chooseLevel(octaves))); }
    `,
    uniforms: {
      thresholdMap: { value: map.thresholdTexture },
      thresholdMapSize: { value: map.size },
      thresholdMapTexel: { value: new Vector2(1 / width, 1 / height) },
      thresholdMapLevels: { value: map.levels },
      // Contrast is not restored, so that the stored values are read.
      thresholdMoments: { value: new Vector3(1, 1, 1) },
      size: { value: size },
      octaves: { value: octaves },
      shift: { value: shift },
    },
    depthTest: false,
    toneMapped: false,
  });
  const geometry = new PlaneGeometry(2, 2);
  const scene = new Scene();
  scene.add(new Mesh(geometry, material));
  const values = new Float32Array(size * size);
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  renderer.readRenderTargetPixels(target, 0, 0, size, size, values);
  renderer.setRenderTarget(null);
  geometry.dispose();
  material.dispose();
  target.dispose();
  return values;
}

const generate = () => TonalArtMap.generate({ style: 'crossHatching', size: 64, tones: 4, seed: 2 });

const thresholdMapTests = {
  /** For each level: the greatest difference to Φ⁻¹ of `.thresholds(level)`, ±3 at most, and how many texels differ after a half turn. */
  async levels() {
    const map = await generate();
    const result = Array.from({ length: map.levels }, (_, level) => {
      const values = sample(map, level);
      let error = 0;
      map.thresholds(level).forEach((threshold, i) => {
        const expected = Math.max(-3, Math.min(3, normalQuantile(threshold)));
        error = Math.max(error, Math.abs(values[i] - expected));
      });
      // A step of a byte is 0.024; what is less comes of rounding coordinates.
      const asymmetric = values.filter((value, i) => Math.abs(value - values[values.length - 1 - i]) > 0.005).length;
      return { texels: values.length, error, asymmetric };
    });
    map.dispose();
    return result;
  },

  /** The greatest difference between samples halfway between texels, both ways, and the means of four texels. */
  async interpolation() {
    const map = await generate();
    const texels = sample(map, 1);
    const between = sample(map, 1, 0.5);
    const size = map.size >> 1;
    let error = 0;
    for (let i = 0; i < texels.length; i++) {
      const [row, column] = [Math.floor(i / size), i % size];
      const at = (y: number, x: number): number => texels[((row + y) % size) * size + ((column + x) % size)];
      error = Math.max(error, Math.abs(between[i] - (at(0, 0) + at(0, 1) + at(1, 0) + at(1, 1)) / 4));
    }
    map.dispose();
    return error;
  },

  /** The greatest difference between samples between two levels and what the two say there, weighed. */
  async betweenLevels() {
    const map = await generate();
    const finer = sample(map, 0);
    // Level 1 at the texel centres of level 0: between its own.
    const coarser = sample(map, 0, 0, 1);
    const mixed = sample(map, 0, 0, 0.25);
    const error = mixed.reduce((worst, g, i) => Math.max(worst, Math.abs(g - 0.75 * finer[i] - 0.25 * coarser[i])), 0);
    const apart = finer.reduce((worst, g, i) => Math.max(worst, Math.abs(g - coarser[i])), 0);
    map.dispose();
    return { error, apart };
  },

  /** Calls that upload texels while the map is drawn three times; then the textures left after dispose. */
  async uploads() {
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const upload = gl.texSubImage2D;
    let calls = 0;
    gl.texSubImage2D = (...args: unknown[]) => {
      calls++;
      Reflect.apply(upload, gl, args);
    };
    const before = renderer.info.memory.textures;
    const map = await generate();
    for (let level = 0; level < 3; level++) sample(map, level);
    const during = renderer.info.memory.textures - before;
    map.dispose();
    gl.texSubImage2D = upload;
    return { calls, during, after: renderer.info.memory.textures - before };
  },

  /** The latest ink and the earliest paper of a map derived from two images of one level. */
  async derived() {
    const images = [new Uint8Array(64).fill(255), new Uint8Array(64).map((_, i) => (i % 8 < 4 ? 0 : 255))];
    const map = TonalArtMap.fromHatchImages({ size: 8, images: images.map((image) => [image]) });
    const values = sample(map, 0);
    // Columns 0 to 3 are ink in the darker image.
    const ink = [...values].filter((_, i) => i % 8 < 4);
    const paper = [...values].filter((_, i) => i % 8 >= 4);
    map.dispose();
    return { latestInk: Math.max(...ink), earliestPaper: Math.min(...paper) };
  },
};

export type ThresholdMapTests = typeof thresholdMapTests;

declare global {
  interface Window {
    thresholdMapTests?: ThresholdMapTests;
  }
}

window.thresholdMapTests = thresholdMapTests;
