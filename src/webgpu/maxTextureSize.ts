import type { WebGPURenderer } from 'three/webgpu';

/** Sizes by backend: WebGL is asked once, since the query blocks. */
const textureSizes = /* @__PURE__ */ new WeakMap<object, number>();

/** Texels per side of the largest texture of the device. */
export function maxTextureSize({ backend }: WebGPURenderer): number {
  let size = textureSizes.get(backend);
  if (size === undefined) {
    const { device, gl } = backend as { device?: GPUDeviceLike; gl?: WebGL2RenderingContext };
    size = device ? device.limits.maxTextureDimension2D : gl ? Number(gl.getParameter(gl.MAX_TEXTURE_SIZE)) : Infinity;
    textureSizes.set(backend, size);
  }
  return size;
}

interface GPUDeviceLike {
  readonly limits: { readonly maxTextureDimension2D: number };
}
