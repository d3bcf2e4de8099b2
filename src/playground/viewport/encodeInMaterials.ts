import { LinearSRGBColorSpace, NoToneMapping, SRGBColorSpace } from 'three';
import { type Node, type NodeBuilder, TSL, type WebGPURenderer } from 'three/webgpu';

/**
 * Makes a renderer draw straight to its canvas, in sRGB colours that every material writes itself, as WebGLRenderer does. By itself WebGPURenderer
 * blends in a linear picture and encodes it afterwards, which makes half-covered pixels lighter. The renderer's clear color is not encoded.
 */
export function encodeInMaterials(renderer: WebGPURenderer): void {
  renderer.outputColorSpace = LinearSRGBColorSpace;
  const getOutput = (color: Node<'vec4'>, builder: NodeBuilder): Node =>
    builder.renderer.isOutputTarget ? TSL.renderOutput(color, NoToneMapping, SRGBColorSpace) : color;
  renderer.contextNode = TSL.context({ getOutput });
}
