import type { AccessorValues } from './GltfValues.js';
import type { GltfWriter } from './GltfWriter.js';
import type { GltfAnimationSampler, GltfChannel, GltfDocument } from './gltfDocument.js';

const VALUES_PER_KEY = { translation: 3, rotation: 4, scale: 3 } as const;
/** Values per key of a cubic spline: the value and two tangents. */
const SPLINE_VALUES = 3;

/**
 * Writes the animations of a document, without tracks that cannot be played: three's mixer would loop forever over keys with the wrong
 * number of values.
 *
 * @param inScene the nodes that are shown; tracks of others belong to other scenes
 * @param shapesOf the number of morph targets of a node's mesh
 * @returns the animations, and the number of tracks left out
 */
export function writeAnimations(
  { animations }: GltfDocument,
  values: AccessorValues,
  writer: GltfWriter,
  inScene: ReadonlySet<number>,
  shapesOf: (node: number) => number,
): { animations: object[]; leftOut: number } {
  let leftOut = 0;
  const written: object[] = [];
  for (const animation of animations) {
    if (!animation) {
      leftOut++;
      continue;
    }
    const channels: object[] = [];
    const samplers: object[] = [];
    for (const channel of animation.channels) {
      // A channel without a node is valid: an extension names its target.
      if (channel && !inScene.has(channel.target.node ?? -1)) continue;
      const sampler = channel && writeSampler(channel, animation.samplers[channel.sampler], values, writer, shapesOf);
      if (!sampler) {
        leftOut++;
        continue;
      }
      channels.push({ sampler: samplers.length, target: channel.target });
      samplers.push(sampler);
    }
    if (channels.length > 0) written.push({ name: animation.name, channels, samplers });
  }
  return { animations: written, leftOut };
}

function writeSampler(
  { target: { node, path } }: GltfChannel,
  sampler: GltfAnimationSampler | undefined,
  values: AccessorValues,
  writer: GltfWriter,
  shapesOf: (node: number) => number,
): object | undefined {
  if (!sampler || path === 'pointer') return undefined;
  const { input, output, interpolation = 'LINEAR' } = sampler;
  const size = path === 'weights' ? 1 : VALUES_PER_KEY[path];
  const perKey = path === 'weights' ? shapesOf(node!) : 1;
  const times = readFinite(values, input, 1);
  const keys = readFinite(values, output, size);
  if (!times?.length || !keys || perKey === 0) return undefined;
  const expected = times.length * size * perKey * (interpolation === 'CUBICSPLINE' ? SPLINE_VALUES : 1);
  if (keys.length !== expected || !isRising(times)) return undefined;
  return { input: writer.add(times, 1), output: writer.add(keys, size), interpolation };
}

/** The values of an accessor, or undefined if data is missing, not finite or of another size. */
function readFinite(values: AccessorValues, accessor: number, size: number): Float32Array | undefined {
  const floats = values.sizeOf(accessor) === size ? values.tryFloats(accessor) : undefined;
  return floats?.every(Number.isFinite) ? floats : undefined;
}

const isRising = (times: Float32Array): boolean => times.every((time, i) => i === 0 || time >= times[i - 1]);
