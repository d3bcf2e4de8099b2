/** Console messages that are remarks about the browser itself, or about another library. Every other warning or error fails the test. */
export const toleratedMessages: readonly { pattern: RegExp; reason: string }[] = [
  {
    pattern: /GPU stall due to ReadPixels/,
    reason: 'Reading pixels back is what the tests are for.',
  },
  {
    pattern: /^THREE\.Clock: This module has been deprecated/,
    reason: 'A remark of three.js about React Three Fiber, which still uses it.',
  },
  {
    pattern: /WebGPU is not available, running under WebGL2 backend|^No available adapters\./,
    reason: 'Remarks of three.js and of browsers without WebGPU, where its WebGPURenderer draws with WebGL.',
  },
  {
    pattern: /Running out of reserved outsideRenderPass queueSerial/,
    reason: "A remark of ANGLE: three's WebGPURenderer uploads the uniforms of every mesh by themselves.",
  },
];
