/** Limits of the device, and warnings about them. */
import { type BufferGeometry, type InstancedMesh, Material, type SkinnedMesh, Texture } from 'three';
import type { NodeBuilder, WebGPURenderer } from 'three/webgpu';
import { warn } from '../material/diagnostics/warn.js';
import { formLayout, hatchNormal } from '../mesh/bake/attributeLayouts.js';

const warned = new Set<string>();

/** Warns once about HatchingNodeMaterial. */
export function warnOnce(sentence: string): void {
  if (warned.has(sentence)) return;
  warned.add(sentence);
  warn(`HatchingNodeMaterial: ${sentence}`);
}

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

/**
 * Whether the device has enough vertex buffers for lines that follow the form of a mesh. WebGPU devices often have eight, and draw nothing
 * of a mesh that needs more. Warns once if they do not suffice.
 *
 * @param isAnchored whether strokes, not lines, follow the form, which need its directions only
 */
export function hasRoomForForm(builder: NodeBuilder, isAnchored: boolean): boolean {
  const { device } = builder.renderer.backend as { device?: { limits: { maxVertexBuffers: number } } };
  if (!device) return true;
  const { maxVertexBuffers } = device.limits;
  const count = countBuffers(builder, isAnchored);
  if (count <= maxVertexBuffers) return true;
  warnOnce(
    `a mesh that follows its form takes ${count} vertex buffers, and the device has ${maxVertexBuffers}: it is drawn without its form. Leave out vertex colors or a second set of texture coordinates, or ask for more buffers: new WebGPURenderer({ requiredLimits: { maxVertexBuffers: ${count} } }).`,
  );
  return false;
}

/** The number of vertex buffers of a mesh that follows its form. */
function countBuffers({ geometry, material, object }: NodeBuilder, isAnchored: boolean): number {
  const { attributes } = geometry as BufferGeometry;
  const { slope, crossing, value } = formLayout;
  const names = ['position', 'normal', hatchNormal.name, slope.name];
  if (!isAnchored) names.push(crossing.name, value.name);
  if (material instanceof Material && material.vertexColors) names.push('color');
  if ((object as SkinnedMesh).isSkinnedMesh) names.push('skinIndex', 'skinWeight');
  for (const [property, map] of Object.entries(material as object)) {
    if (!(map instanceof Texture)) continue;
    names.push(map.channel > 0 ? `uv${map.channel}` : 'uv');
    if (property === 'normalMap') names.push('tangent');
  }
  const used = names.filter((name) => name in attributes).map((name) => attributes[name]);
  const buffers = new Set(used.map((attribute) => ('data' in attribute ? attribute.data : attribute)));
  const { isInstancedMesh, instanceColor } = object as InstancedMesh;
  return buffers.size + Number(isInstancedMesh === true) + Number(isInstancedMesh === true && instanceColor !== null);
}
